// The same work on many items, spread over the processors. The results do not depend on how many
// there are.
#pragma once

#include <algorithm>
#include <atomic>
#include <exception>
#include <thread>
#include <vector>

namespace rotorbench {

/// {work(0), ..., work(count - 1)}; `work` is called from several threads at once. Throws what the
/// first failed call threw. The result type needs a default constructor.
template <class Work>
auto inParallel(std::size_t count, const Work& work) {
  std::vector<decltype(work(std::size_t{}))> results(count);
  std::vector<std::exception_ptr> faults(count);
  std::atomic<std::size_t> next = 0;
  const auto worker = [&] {
    for (std::size_t i = next++; i < count; i = next++) {
      try {
        results[i] = work(i);
      } catch (...) {
        faults[i] = std::current_exception();
      }
    }
  };
  const std::size_t most = std::max(1U, std::thread::hardware_concurrency());
  {
    std::vector<std::jthread> threads;
    for (std::size_t i = 1; i < std::min(most, count); ++i) threads.emplace_back(worker);
    worker();
  }
  for (const std::exception_ptr& fault : faults) {
    if (fault) std::rethrow_exception(fault);
  }
  return results;
}

}  // namespace rotorbench
