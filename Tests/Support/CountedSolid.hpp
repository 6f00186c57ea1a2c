#pragma once

#include <Cutwater/Sdf/Solid.hpp>

namespace cutwater::test {

/// A solid that counts how often it is asked for a value, a gradient or an owner.
template <std::floating_point T>
class CountedSolid final : public SignedDistanceFunction<T> {
 public:
  CountedSolid(Solid<T> solid, std::size_t* asked) : solid_(std::move(solid)), asked_(asked) {}

 private:
  T localSignedDistance(const Vec3<T>& p) const override { return counted().signedDistance(p); }
  Vec3<T> localGradient(const Vec3<T>& p) const override { return counted().gradient(p); }
  SurfaceOwner localOwner(const Vec3<T>& p) const override { return counted().owner(p); }
  Guarantee<T> localGuarantee() const override { return solid_.guarantee(); }
  Box<T> localBoundingBox() const override { return solid_.boundingBox(); }
  Box<T> localClearanceBox() const override { return solid_.clearanceBox(); }

  [[nodiscard]] const Solid<T>& counted() const {
    ++*asked_;
    return solid_;
  }

  Solid<T> solid_;
  std::size_t* asked_;
};

}  // namespace cutwater::test
