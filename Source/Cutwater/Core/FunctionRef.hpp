#pragma once

#include <concepts>
#include <memory>
#include <type_traits>
#include <utility>

namespace cutwater {

/// Defined for signatures `Result(Args...)`.
template <typename Signature>
class FunctionRef;

/// A reference to any callable: two pointers, no allocation. It does not own the callable, so use
/// it only for parameters that are needed during the call.
template <typename Result, typename... Args>
class FunctionRef<Result(Args...)> {
 public:
  template <typename F>
  requires(!std::same_as<std::remove_cvref_t<F>, FunctionRef> &&
           std::is_invocable_r_v<Result, F&, Args...>)
      FunctionRef(F&& callable)  // NOLINT(google-explicit-constructor): made to be converted to
      : object_(address(callable)), call_([](void* object, Args... args) -> Result {
          using Callable = std::remove_reference_t<F>;
          return (*reinterpret_cast<Callable*>(object))(std::forward<Args>(args)...);
        }) {}

  /// Calls the callable.
  Result operator()(Args... args) const { return call_(object_, std::forward<Args>(args)...); }

 private:
  template <typename Callable>
  static void* address(Callable& callable) {
    if constexpr (std::is_function_v<Callable>) {
      return reinterpret_cast<void*>(&callable);  // POSIX guarantees that this works
    } else {
      return const_cast<void*>(static_cast<const void*>(std::addressof(callable)));
    }
  }

  void* object_;
  Result (*call_)(void*, Args...);
};

}  // namespace cutwater
