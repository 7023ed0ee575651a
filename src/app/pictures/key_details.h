// The details of keys (hierarchy/detail/key_detail.h), which a worker thread measures once per key, in about a
// second per million leaves.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <list>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "family/shared_hierarchy.h"
#include "hierarchy/detail/key_detail.h"

namespace interleaf {

class KeyDetails {
  public:
    using Keys = std::vector<SharedHierarchy>;
    using Measured = std::shared_ptr<const KeyDetail>;

    /// \param max_bytes  memory of all details together; the least recently wanted ones go first. Details of
    ///     keys that are wanted stay in any case.
    explicit KeyDetails(std::size_t max_bytes = std::size_t{512} << 20);

    /// Lets the worker measure those of \p keys that are not measured, in this order, instead of those wanted
    /// before. A key that cannot be measured is left out. The same list again changes nothing.
    void want(Keys keys);

    /// The details of \p key; null if they are not measured.
    Measured find(const SharedHierarchy& key) const;

    /// The part of the wanted keys' leaves that is measured, 0 to 1; none if the worker has nothing to do.
    std::optional<double> progress() const;

    /// Waits until the worker has nothing to do.
    void wait();

  private:
    struct Entry {
        SharedHierarchy key;
        Measured measured;  ///< null if the key cannot be measured
        std::size_t bytes = 0;
    };
    const Entry* entry_of(const SharedHierarchy& key) const;
    const SharedHierarchy* next() const;
    bool is_wanted(const SharedHierarchy& key) const;
    void insert(Entry entry);
    Entry measure(const SharedHierarchy& key, const std::stop_token& stop);
    void work(const std::stop_token& stop);

    std::size_t max_bytes_;
    mutable std::mutex mutex_;
    std::condition_variable_any changed_;
    std::list<Entry> entries_;  ///< the most recently measured or wanted first
    Keys wanted_;
    bool is_working_ = false;
    double part_ = 0;      ///< of the key in progress
    std::jthread worker_;  ///< last member: must end before the members it uses
};

}  // namespace interleaf
