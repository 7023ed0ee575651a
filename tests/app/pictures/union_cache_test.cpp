// Tests of the cache of unions: it gives what unite() gives, makes unions ahead, and stays within its memory.
#include "app/pictures/union_cache.h"

#include <algorithm>
#include <chrono>
#include <mutex>
#include <random>
#include <thread>
#include <vector>

#include <doctest/doctest.h>

#include "app/pictures/held_unions.h"
#include "hierarchy/error.h"
#include "shapes/shapes.h"

using namespace interleaf;
using namespace interleaf::testing;

namespace {

std::vector<SharedHierarchy> some_keys() {
    std::vector<SharedHierarchy> keys;
    for (const char* const name : {"star", "sphere", "bone", "cushion"})
        keys.emplace_back(make_key(*find_shape(name), {.leaves = 400, .tolerance = {}}));
    return keys;
}

bool are_equal(const UnionMesh& a, const UnionMesh& b) {
    return std::ranges::equal(a.triangles, b.triangles) && a.positions.size() == b.positions.size() &&
           std::ranges::equal(a.positions.back(), b.positions.back());
}

UnionMesh united(const UnionCache::Keys& keys) {
    std::vector<const Hierarchy*> pointers;
    for (const SharedHierarchy& key : keys.hierarchies) pointers.push_back(&*key);
    return unite(pointers);
}

}  // namespace

TEST_CASE("the cache gives the union, waits for it once, and then has it") {
    const auto keys = some_keys();
    UnionCache cache;
    const UnionCache::Keys pair{keys[0], keys[1]};
    const auto first = cache.get(pair);
    CHECK_FALSE(first.is_ready);
    CHECK(are_equal(first.united->mesh, united(pair)));
    CHECK(first.united->form.product_count == 3);
    const auto second = cache.get(pair);
    CHECK(second.is_ready);
    CHECK(second.united == first.united);
    CHECK(cache.byte_count() == first.united->byte_count());
}

TEST_CASE("the same keys that blend in two ways have two unions, and the cache keeps both") {
    const auto keys = some_keys();
    UnionCache cache;
    const UnionCache::Keys straight{keys[0], keys[1]};
    const UnionCache::Keys turning({keys[0], keys[1]}, BlendKind::turning);
    CHECK_FALSE(cache.get(straight).united->mesh.turning);
    CHECK(cache.get(turning).united->mesh.turning);
    CHECK(cache.get(straight).is_ready);
    CHECK(cache.get(turning).is_ready);
}

TEST_CASE("a union that was made ahead is ready, and a replaced wish is not made") {
    const auto keys = some_keys();
    UnionCache cache;
    cache.prepare({{keys[0], keys[1]}, {keys[1], keys[2]}});
    cache.wait();
    CHECK(cache.get({keys[0], keys[1]}).is_ready);
    CHECK(cache.get({keys[1], keys[2]}).is_ready);
    CHECK_FALSE(cache.get({keys[2], keys[1]}).is_ready);  // another order, other streams
}

TEST_CASE("a wanted union is coming until it is made") {
    const auto keys = some_keys();
    UnionCache cache;
    const UnionCache::Keys pair{keys[0], keys[1]}, other{keys[1], keys[2]};
    CHECK_FALSE(cache.is_coming(pair));
    cache.prepare({pair});
    while (cache.is_coming(pair)) cache.wait();
    CHECK(cache.get(pair).is_ready);
    CHECK_FALSE(cache.is_coming(other));
}

TEST_CASE("the least recently used unions go where memory is short, but never the one in use") {
    const auto keys = some_keys();
    const std::size_t bytes = UnionCache().get({keys[0], keys[1]}).united->byte_count();
    UnionCache cache(bytes * 5 / 2);
    CHECK_FALSE(cache.get({keys[0], keys[1]}).is_ready);
    CHECK_FALSE(cache.get({keys[0], keys[2]}).is_ready);
    CHECK(cache.get({keys[0], keys[1]}).is_ready);
    CHECK_FALSE(cache.get({keys[0], keys[3]}).is_ready);
    CHECK(cache.byte_count() <= bytes * 5 / 2);
    CHECK(cache.get({keys[0], keys[1]}).is_ready);
    CHECK_FALSE(cache.get({keys[0], keys[2]}).is_ready);

    UnionCache tiny(1);
    const auto only = tiny.get({keys[0], keys[1]});
    tiny.prepare({{keys[2], keys[3]}});
    tiny.wait();
    CHECK(tiny.get({keys[0], keys[1]}).is_ready);
}

TEST_CASE("where memory is short, the likeliest wishes are kept, and the same wishes make nothing again") {
    const auto keys = some_keys();
    const UnionCache::Keys shown{keys[0], keys[1]};
    const std::vector<UnionCache::Keys> wishes{{keys[0], keys[2]}, {keys[0], keys[3]}, {keys[1], keys[2]}};
    const std::size_t bytes = UnionCache().get(shown).united->byte_count();
    UnionCache cache(bytes * 5 / 2);
    CHECK_FALSE(cache.get(shown).is_ready);
    cache.prepare(wishes);
    cache.wait();
    const std::size_t before = cache.byte_count();
    CHECK(before <= bytes * 5 / 2);
    cache.prepare(wishes);
    cache.wait();
    CHECK(cache.byte_count() == before);
    CHECK(cache.get(shown).is_ready);
    CHECK(cache.get(wishes[0]).is_ready);
    CHECK_FALSE(cache.get(wishes[2]).is_ready);
}

TEST_CASE("keys without common roots fail when they are asked for, not when they are made ahead") {
    const auto keys = some_keys();
    const SharedHierarchy other(make_key(*find_shape("brezel"), {.leaves = 200, .tolerance = {}}));
    UnionCache cache;
    cache.prepare({{keys[0], other}, {keys[0], keys[1]}});
    cache.wait();
    CHECK_THROWS_AS(cache.get({keys[0], other}), InputError);
    CHECK(cache.get({keys[0], keys[1]}).is_ready);
}

TEST_CASE("random requests, with and without the worker, always give the right union") {
    const auto keys = some_keys();
    std::mt19937 random(1);
    UnionCache cache(std::size_t{200} << 10);
    const auto some = [&] {
        UnionCache::Keys chosen;
        for (std::size_t count = 1 + random() % 3; count > 0; --count)
            chosen.hierarchies.push_back(keys[random() % 4]);
        return chosen;
    };
    for (int step = 0; step < 300; ++step) {
        if (random() % 3 == 0) cache.prepare({some(), some()});
        const UnionCache::Keys wanted = some();
        REQUIRE(are_equal(cache.get(wanted).united->mesh, united(wanted)));
    }
}

namespace {

std::mutex begun_mutex;
std::vector<UnionCache::Keys> begun;  ///< what noted_union() was to make, in this order

UnionCache::Prepared noted_union(const UnionCache::Keys& keys, UnionMesh& scratch) {
    {
        const std::lock_guard lock(begun_mutex);
        begun.push_back(keys);
    }
    return union_when_released(keys, scratch);
}

}  // namespace

TEST_CASE("a slow union is not waited for, comes before all that are made ahead, and is there later") {
    const auto keys = some_keys();
    begun.clear();
    UnionCache cache(UnionCache::usual_bytes, noted_union);
    const UnionCache::Keys urgent{keys[0], keys[3]};
    unions_are_held = true;
    cache.prepare({{keys[0], keys[1]}, {keys[1], keys[2]}, {keys[2], keys[3]}});
    const auto first = cache.get_within(urgent, std::chrono::milliseconds(5));
    CHECK(first.united == nullptr);
    CHECK_FALSE(first.is_ready);
    const std::jthread release([] {
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
        unions_are_held = false;
    });
    const auto later = cache.get_within(urgent, std::chrono::seconds(10));
    REQUIRE(later.united != nullptr);
    CHECK_FALSE(later.is_ready);
    CHECK(are_equal(later.united->mesh, united(urgent)));
    CHECK(cache.get_within(urgent, std::chrono::milliseconds(0)).is_ready);
    cache.wait();
    // The worker may have begun the first of the others before.
    REQUIRE(begun.size() == 4);
    CHECK((UnionCache::are_same(begun[0], urgent) || UnionCache::are_same(begun[1], urgent)));
}

TEST_CASE("a union that cannot be made fails for the one who waits for it, each time") {
    const auto keys = some_keys();
    const SharedHierarchy other(make_key(*find_shape("brezel"), {.leaves = 200, .tolerance = {}}));
    UnionCache cache;
    for (int i = 0; i < 2; ++i)
        CHECK_THROWS_AS(cache.get_within({keys[0], other}, std::chrono::seconds(10)), InputError);
    CHECK(cache.get_within({keys[0], keys[1]}, std::chrono::seconds(10)).united != nullptr);
}
