#pragma once

// The patterns of TpmsPattern and their gradients, lane by lane.

#include <Cutwater/Simd/TurnTrigonometry.inl>
#include <Cutwater/Tpms/Detail/PatternBatch.hpp>

namespace cutwater::CUTWATER_SIMD {

template <typename Real>
struct Sample {
  Real value;
  Triple<Real> gradient;
};

/// Sines and cosines of the three angles at a point.
template <typename T>
struct Angles {
  using Real = Lanes<T>;
  Real sx, cx, sy, cy, sz, cz;
};

/// The angles at consecutive points, whose x, y and z in cells are in rows of this length.
template <typename T>
CUTWATER_INLINE inline Angles<T> anglesInRows(const T* inCells, int row) {
  const auto x = sineCosineOfTurns<T>(load(inCells));
  const auto y = sineCosineOfTurns<T>(load(inCells + row));
  const auto z = sineCosineOfTurns<T>(load(inCells + 2 * row));
  return {x.sine, x.cosine, y.sine, y.cosine, z.sine, z.cosine};
}

/// The angles at one point, in all lanes. Its sines and cosines are found in neighbouring lanes.
template <typename T>
CUTWATER_INLINE inline Angles<T> anglesAtPoint(const T* inCells) {
  constexpr int kRoom = kLanesOf<T> < 4 ? 4 : kLanesOf<T>;
  alignas(64) T places[kRoom] = {inCells[0], inCells[1], inCells[2]};
  alignas(64) T sines[kRoom];
  alignas(64) T cosines[kRoom];
  for (int i = 0; i < 3; i += kLanesOf<T>) {
    const auto found = sineCosineOfTurns<T>(load(places + i));
    store(sines + i, found.sine);
    store(cosines + i, found.cosine);
  }
  return {broadcast(sines[0]),   broadcast(cosines[0]), broadcast(sines[1]),
          broadcast(cosines[1]), broadcast(sines[2]),   broadcast(cosines[2])};
}

/// Sines and cosines of twice the angles.
template <typename T>
struct TwiceAngles {
  using Real = Lanes<T>;
  Real sx, cx, sy, cy, sz, cz;

  CUTWATER_INLINE explicit TwiceAngles(const Angles<T>& a)
      : sx(twice(a.sx * a.cx)),
        cx(a.cx * a.cx - a.sx * a.sx),
        sy(twice(a.sy * a.cy)),
        cy(a.cy * a.cy - a.sy * a.sy),
        sz(twice(a.sz * a.cz)),
        cz(a.cz * a.cz - a.sz * a.sz) {}

  CUTWATER_INLINE static Real twice(Real a) { return a + a; }
};

struct GyroidFormula {
  template <typename T>
  CUTWATER_INLINE static Sample<Lanes<T>> at(const Angles<T>& a) {
    return {a.sx * a.cy + a.sy * a.cz + a.sz * a.cx,
            {a.cx * a.cy - a.sz * a.sx, a.cy * a.cz - a.sx * a.sy, a.cz * a.cx - a.sy * a.sz}};
  }
};

struct SchwarzPFormula {
  template <typename T>
  CUTWATER_INLINE static Sample<Lanes<T>> at(const Angles<T>& a) {
    return {a.cx + a.cy + a.cz, {-a.sx, -a.sy, -a.sz}};
  }
};

struct SchwarzDFormula {
  template <typename T>
  CUTWATER_INLINE static Sample<Lanes<T>> at(const Angles<T>& a) {
    return {a.cx * a.cy * a.cz - a.sx * a.sy * a.sz,
            {-(a.sx * a.cy * a.cz + a.cx * a.sy * a.sz), -(a.cx * a.sy * a.cz + a.sx * a.cy * a.sz),
             -(a.cx * a.cy * a.sz + a.sx * a.sy * a.cz)}};
  }
};

struct SchwarzD4Formula {
  template <typename T>
  CUTWATER_INLINE static Sample<Lanes<T>> at(const Angles<T>& a) {
    const auto cc = a.cy * a.cz;
    const auto ss = a.sy * a.sz;
    const auto sc = a.sy * a.cz;
    const auto cs = a.cy * a.sz;
    return {a.sx * (ss + cc) + a.cx * (sc + cs),
            {a.cx * (ss + cc) - a.sx * (sc + cs), a.sx * (cs - sc) + a.cx * (cc - ss),
             a.sx * (sc - cs) + a.cx * (cc - ss)}};
  }
};

/// T = s2x cy sz + s2y cz sx + s2z cx sy
template <typename T>
CUTWATER_INLINE inline Sample<Lanes<T>> twistedTerms(const Angles<T>& a, const TwiceAngles<T>& b) {
  const auto two = broadcast(T(2));
  return {b.sx * a.cy * a.sz + b.sy * a.cz * a.sx + b.sz * a.cx * a.sy,
          {two * b.cx * a.cy * a.sz + b.sy * a.cz * a.cx - b.sz * a.sx * a.sy,
           two * b.cy * a.cz * a.sx + b.sz * a.cx * a.cy - b.sx * a.sy * a.sz,
           two * b.cz * a.cx * a.sy + b.sx * a.cy * a.cz - b.sy * a.sz * a.sx}};
}

/// C = c2x c2y + c2y c2z + c2z c2x
template <typename T>
CUTWATER_INLINE inline Sample<Lanes<T>> pairedTerms(const TwiceAngles<T>& b) {
  const auto two = broadcast(T(2));
  return {b.cx * b.cy + b.cy * b.cz + b.cz * b.cx,
          {-(two * b.sx * (b.cy + b.cz)), -(two * b.sy * (b.cz + b.cx)),
           -(two * b.sz * (b.cx + b.cy))}};
}

struct LidinoidFormula {
  template <typename T>
  CUTWATER_INLINE static Sample<Lanes<T>> at(const Angles<T>& a) {
    const TwiceAngles<T> b(a);
    const auto half = broadcast(T(0.5));
    const auto t = twistedTerms(a, b);
    const auto c = pairedTerms(b);
    return {half * (t.value - c.value) + broadcast(T(0.15)), half * (t.gradient - c.gradient)};
  }
};

struct SplitPFormula {
  template <typename T>
  CUTWATER_INLINE static Sample<Lanes<T>> at(const Angles<T>& a) {
    const TwiceAngles<T> b(a);
    const auto t = twistedTerms(a, b);
    const auto c = pairedTerms(b);
    const auto ofT = broadcast(T(1.1));
    const auto ofC = broadcast(T(0.2));
    const auto ofSum = broadcast(T(0.4));
    const auto slope = broadcast(T(0.8));
    return {ofT * t.value - ofC * c.value - ofSum * (b.cx + b.cy + b.cz),
            ofT * t.gradient - ofC * c.gradient + slope * Triple<Lanes<T>>{b.sx, b.sy, b.sz}};
  }
};

struct NeoviusFormula {
  template <typename T>
  CUTWATER_INLINE static Sample<Lanes<T>> at(const Angles<T>& a) {
    const auto three = broadcast(T(3));
    const auto four = broadcast(T(4));
    return {three * (a.cx + a.cy + a.cz) + four * a.cx * a.cy * a.cz,
            {-(a.sx * (three + four * a.cy * a.cz)), -(a.sy * (three + four * a.cz * a.cx)),
             -(a.sz * (three + four * a.cx * a.cy))}};
  }
};

struct IwpFormula {
  template <typename T>
  CUTWATER_INLINE static Sample<Lanes<T>> at(const Angles<T>& a) {
    const TwiceAngles<T> b(a);
    const auto two = broadcast(T(2));
    return {two * (a.cx * a.cy + a.cy * a.cz + a.cz * a.cx) - (b.cx + b.cy + b.cz),
            {two * (b.sx - a.sx * (a.cy + a.cz)), two * (b.sy - a.sy * (a.cz + a.cx)),
             two * (b.sz - a.sz * (a.cx + a.cy))}};
  }
};

struct FrdFormula {
  template <typename T>
  CUTWATER_INLINE static Sample<Lanes<T>> at(const Angles<T>& a) {
    const TwiceAngles<T> b(a);
    const auto four = broadcast(T(4));
    const auto c = pairedTerms(b);
    const Triple<Lanes<T>> ofProduct{a.sx * a.cy * a.cz, a.cx * a.sy * a.cz, a.cx * a.cy * a.sz};
    const Triple<Lanes<T>> none{broadcast(T(0)), broadcast(T(0)), broadcast(T(0))};
    return {four * a.cx * a.cy * a.cz - c.value, none - four * ofProduct - c.gradient};
  }
};

struct FischerKochSFormula {
  template <typename T>
  CUTWATER_INLINE static Sample<Lanes<T>> at(const Angles<T>& a) {
    const TwiceAngles<T> b(a);
    const auto two = broadcast(T(2));
    return {b.cx * a.sy * a.cz + a.cx * b.cy * a.sz + a.sx * a.cy * b.cz,
            {a.cx * a.cy * b.cz - a.sx * b.cy * a.sz - two * b.sx * a.sy * a.cz,
             b.cx * a.cy * a.cz - a.sx * a.sy * b.cz - two * a.cx * b.sy * a.sz,
             a.cx * b.cy * a.cz - b.cx * a.sy * a.sz - two * a.sx * a.cy * b.sz}};
  }
};

/// Calls what(the pattern's formula).
template <typename What>
CUTWATER_INLINE inline void withFormula(detail::TpmsKind kind, What what) {
  using detail::TpmsKind;
  switch (kind) {
    case TpmsKind::Gyroid:
      return what(GyroidFormula{});
    case TpmsKind::SchwarzP:
      return what(SchwarzPFormula{});
    case TpmsKind::SchwarzD:
      return what(SchwarzDFormula{});
    case TpmsKind::SchwarzD4:
      return what(SchwarzD4Formula{});
    case TpmsKind::Lidinoid:
      return what(LidinoidFormula{});
    case TpmsKind::SplitP:
      return what(SplitPFormula{});
    case TpmsKind::Neovius:
      return what(NeoviusFormula{});
    case TpmsKind::Iwp:
      return what(IwpFormula{});
    case TpmsKind::Frd:
      return what(FrdFormula{});
    case TpmsKind::FischerKochS:
      return what(FischerKochSFormula{});
  }
}

}  // namespace cutwater::CUTWATER_SIMD
