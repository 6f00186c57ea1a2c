#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Core/Parallel.hpp>

#include <algorithm>
#include <atomic>
#include <exception>

#ifdef _OPENMP
#include <omp.h>
#endif

namespace cutwater {

namespace {

/// Assigns ranges to whichever thread asks next, until no work is left or a call fails.
class Dispenser {
 public:
  Dispenser(std::size_t count, const ParallelOptions& options,
            FunctionRef<void(std::size_t, std::size_t)> body)
      : count_(count),
        grain_(std::max<std::size_t>(options.grain, 1)),
        options_(options),
        body_(body) {}

  /// `isStarter`: of the thread that started the work, which alone reports progress.
  void work(bool isStarter) noexcept {
    const bool reports = isStarter && options_.progress != nullptr;
    try {
      for (;;) {
        const auto begin = next_.fetch_add(grain_);
        if (begin >= count_ || failed_.load()) return;
        body_(begin, std::min(begin + grain_, count_));
        if (reports) report();
      }
    } catch (...) {
      if (!failed_.exchange(true)) error_ = std::current_exception();
    }
  }

  void finish() const {
    if (error_) std::rethrow_exception(error_);
    if (options_.progress) options_.progress(1.0);
  }

 private:
  void report() const {
    const auto handedOut = std::min(next_.load(), count_);
    options_.progress(static_cast<double>(handedOut) / static_cast<double>(count_));
  }

  std::size_t count_;
  std::size_t grain_;
  const ParallelOptions& options_;
  FunctionRef<void(std::size_t, std::size_t)> body_;
  std::atomic<std::size_t> next_{0};
  std::atomic<bool> failed_{false};
  std::exception_ptr error_;
};

int threadsFor(std::size_t ranges, int wanted) {
#ifdef _OPENMP
  if (omp_in_parallel() != 0) return 1;
  const int usual = omp_get_max_threads();
  // Where a thread cannot be had, OpenMP's runtime ends the process.
  const int most = std::min(wanted > 0 ? wanted : usual, std::max(usual, 4 * omp_get_num_procs()));
  return static_cast<int>(std::clamp<std::size_t>(ranges, 1, static_cast<std::size_t>(most)));
#else
  static_cast<void>(ranges);
  static_cast<void>(wanted);
  return 1;
#endif
}

}  // namespace

void parallelFor(std::size_t count, const ParallelOptions& options,
                 FunctionRef<void(std::size_t, std::size_t)> body) {
  require(options.threads >= 0, "parallelFor: need threads >= 0",
          Named{"threads", options.threads});
  if (count == 0) return;
  const auto grain = std::max<std::size_t>(options.grain, 1);
  if (count <= grain && !options.progress) {  // one range, such as a small batch of points
    body(0, count);
    return;
  }
  Dispenser dispenser(count, options, body);
  const int threads = threadsFor((count + grain - 1) / grain, options.threads);
  if (threads == 1) {
    dispenser.work(true);  // in a region of the caller's this may be any thread of its team
  } else {
#ifdef _OPENMP
#pragma omp parallel num_threads(threads)
    dispenser.work(omp_get_thread_num() == 0);
#endif
  }
  dispenser.finish();
}

int availableThreads() {
  return threadsFor(static_cast<std::size_t>(1) << 20U, 0);
}

}  // namespace cutwater
