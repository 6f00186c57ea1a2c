#pragma once

#include <Cutwater/Core/AffineMap.hpp>

namespace cutwater::detail {

/// A box that the inverse of the map takes into the domain: the box around the domain's image,
/// scaled about its centre. Empty if none is certain.
template <std::floating_point T>
[[nodiscard]] Box<T> domainUnder(const AffineMap<T>& map, const AffineMap<T>& inverse,
                                 const Box<T>& domain);

}  // namespace cutwater::detail
