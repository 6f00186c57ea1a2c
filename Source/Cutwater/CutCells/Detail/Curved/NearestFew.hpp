#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

namespace cutwater {

/// The items of the least order among all that were added, so many at most.
template <typename Order, typename Item>
class NearestFew {
 public:
  struct Entry {
    Order order;
    Item item;
  };

  explicit NearestFew(std::size_t most) : most_(most) { entries_.reserve(most); }

  /// Whether an item of this order would be kept now.
  [[nodiscard]] bool mayTake(const Order& order) const {
    return entries_.size() < most_ || order < entries_.front().order;
  }
  void add(const Order& order, const Item& item) {
    if (!mayTake(order)) return;
    if (entries_.size() == most_) {
      std::ranges::pop_heap(entries_, {}, &Entry::order);
      entries_.pop_back();
    }
    entries_.push_back({order, item});
    std::ranges::push_heap(entries_, {}, &Entry::order);
  }
  /// The least first. Nothing may be added after it, but to cleared ones.
  [[nodiscard]] std::span<const Entry> sorted() {
    std::ranges::sort_heap(entries_, {}, &Entry::order);
    return entries_;
  }
  void clear() { entries_.clear(); }

 private:
  std::size_t most_;
  std::vector<Entry> entries_;  // a heap, that of the greatest order in front
};

}  // namespace cutwater
