// The unions of the last sets of keys, and those that will be needed soon, which a worker thread makes ahead. The
// worker also makes a union that get_within() asks for, so that the window waits only as long as it wants to. get()
// makes a missing union on the caller's thread.
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <exception>
#include <initializer_list>
#include <list>
#include <memory>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

#include "family/blend_kind.h"
#include "family/shared_hierarchy.h"
#include "hierarchy/union_mesh.h"
#include "render/prepared_surface.h"

namespace interleaf {

class UnionCache {
  public:
    /// The keys of a union, and how they blend.
    struct Keys {
        std::vector<SharedHierarchy> hierarchies;
        BlendKind blend = BlendKind::straight;

        Keys() = default;
        Keys(std::initializer_list<SharedHierarchy> straight) : hierarchies(straight) {}
        Keys(std::vector<SharedHierarchy> keys, BlendKind kind) : hierarchies(std::move(keys)), blend(kind) {}

        bool empty() const { return hierarchies.empty(); }
    };
    using Prepared = std::shared_ptr<const PreparedSurface>;

    /// Makes the union of \p keys. \p scratch keeps memory from one call to the next.
    using Maker = Prepared (*)(const Keys& keys, UnionMesh& scratch);

    static constexpr std::size_t usual_bytes = std::size_t{512} << 20;

    struct Result {
        Prepared united;  ///< null if it is not made yet
        bool is_ready;    ///< whether the union was there already, so that the caller has not waited
    };

    /// \param max_bytes  memory of all unions together; the least recently used ones go first. The last
    ///     returned union stays in any case.
    /// \param maker  null for the usual one; a test passes a slow one
    explicit UnionCache(std::size_t max_bytes = usual_bytes, Maker maker = nullptr);

    /// Whether both are the same keys in the same order, and blend in the same way.
    static bool are_same(const Keys& a, const Keys& b);

    /// The union of \p keys. Waits for the worker if it is making this union, and makes it otherwise.
    /// \throw what unite() throws
    Result get(const Keys& keys);

    /// The union of \p keys if the worker has made it within \p longest. Otherwise the worker makes it before
    /// all others, and a later call gets it.
    /// \throw what unite() throws
    Result get_within(const Keys& keys, std::chrono::milliseconds longest);

    /// The union of \p keys if it is made; null otherwise. It does not count as used.
    Prepared peek(const Keys& keys) const;

    /// The union of \p keys, which is not kept: for keys that will not come again.
    /// \throw what unite() throws
    Prepared make(const Keys& keys);

    /// Lets the worker make the unions of \p wanted that are missing, in this order, instead of those wanted
    /// before. A union that cannot be made, or for which there is no room beside earlier ones of the list, is
    /// left out. The same list again changes nothing.
    void prepare(std::vector<Keys> wanted);

    /// Whether the worker is making, or is going to make, the union of \p keys.
    bool is_coming(const Keys& keys) const;

    /// Waits until the worker has nothing to do.
    void wait();

    std::size_t byte_count() const;

  private:
    struct Entry {
        Keys keys;
        Prepared united;
        std::size_t bytes;
    };
    using Entries = std::list<Entry>;  ///< the most recently used first
    Prepared find(const Keys& keys);
    Keys next_wanted();
    bool has(const Keys& keys) const;
    bool is_wished(const Keys& keys) const;
    void insert(const Keys& keys, Prepared united, bool is_used);
    void work(const std::stop_token& stop);

    /// A union that could not be made.
    struct Fault {
        Keys keys;
        std::exception_ptr error;
    };

    std::size_t max_bytes_;
    Maker maker_;
    UnionMesh scratch_;  ///< of get()
    mutable std::mutex mutex_;
    std::condition_variable_any changed_;
    Entries entries_;
    std::size_t bytes_ = 0;
    std::vector<Keys> wished_;  ///< of the last prepare()
    std::vector<Keys> wanted_;  ///< those of them that the worker has not begun
    Keys urgent_;               ///< of the last get_within() that got nothing; empty for none
    Fault fault_;               ///< of the last union that was urgent
    Keys in_progress_;          ///< what the worker makes now; empty for nothing
    std::jthread worker_;       ///< last member: must end before the members it uses
};

}  // namespace interleaf
