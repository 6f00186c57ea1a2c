#include <Cutwater/Mesh/DcelSDF.hpp>
#include <Cutwater/Mesh/Detail/DcelIndex.hpp>

namespace cutwater {

template <std::floating_point T>
DcelSDF<T>::DcelSDF(DcelMesh<T> mesh)
    : MeshFunction<T, DcelIndex<T>>(std::make_shared<const DcelIndex<T>>(std::move(mesh))) {}

template <std::floating_point T>
const DcelMesh<T>& DcelSDF<T>::mesh() const {
  return this->index().mesh();
}

template class DcelSDF<float>;
template class DcelSDF<double>;

}  // namespace cutwater
