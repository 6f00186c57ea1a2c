#include <deal.II/mock.h>
