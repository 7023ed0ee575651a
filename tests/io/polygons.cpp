#include "io/polygons.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <utility>

#include <fmt/core.h>
#include <glm/geometric.hpp>

namespace interleaf {
namespace {

using std::numbers::pi;

double turn(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Whether two edges meet, possibly only at an end.
bool do_meet(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c, glm::dvec2 d) {
    const auto on = [](glm::dvec2 p, glm::dvec2 q, glm::dvec2 r) {
        return turn(p, q, r) == 0 && glm::dot(r - p, r - q) <= 0;
    };
    if (on(a, b, c) || on(a, b, d) || on(c, d, a) || on(c, d, b)) return true;
    return (turn(a, b, c) > 0) != (turn(a, b, d) > 0) && (turn(c, d, a) > 0) != (turn(c, d, b) > 0);
}

double uniform(std::mt19937& random, double least, double most) {
    return std::uniform_real_distribution<double>(least, most)(random);
}

}  // namespace

std::vector<Outline> outlines() {
    return {
        {"L", {{0, 0}, {5, 0}, {5, 1}, {1, 1}, {1, 4}, {0, 4}}, 8},
        {"T", {{2, 0}, {3, 0}, {3, 3}, {5, 3}, {5, 4}, {0, 4}, {0, 3}, {2, 3}}, 8},
        {"U", {{0, 0}, {5, 0}, {5, 4}, {4, 4}, {4, 1}, {1, 1}, {1, 4}, {0, 4}}, 11},
        {"plus",
         {{1, 0}, {2, 0}, {2, 1}, {3, 1}, {3, 2}, {2, 2}, {2, 3}, {1, 3}, {1, 2}, {0, 2}, {0, 1}, {1, 1}},
         5},
        {"notch", {{0, 0}, {4, 0}, {4, 4}, {2, 1}, {0, 4}}, 10},
        {"deep notch", {{0, 0}, {6, 0}, {6, 3}, {1, 3}, {5, 2}, {5, 1}, {0, 1}}, 10},
        {"arrow", {{0, 0}, {4, 2}, {0, 4}, {1, 2}}, 6},
    };
}

Polygon begun_at(const Polygon& polygon, std::size_t corner) {
    Polygon result = polygon;
    std::rotate(result.begin(), result.begin() + static_cast<std::ptrdiff_t>(corner), result.end());
    return result;
}

Polygon turned_over(const Polygon& polygon) {
    return {polygon.rbegin(), polygon.rend()};
}

Polygon star_shaped(std::size_t count, std::mt19937& random) {
    // Equal parts of the circle, so that no angle is over 180 degrees.
    Polygon polygon;
    for (std::size_t i = 0; i < count; ++i) {
        const double part = static_cast<double>(i) + uniform(random, 0.05, 0.95);
        const double angle = 2 * pi * part / static_cast<double>(count);
        polygon.push_back(uniform(random, 0.05, 1) * glm::dvec2(std::cos(angle), std::sin(angle)));
    }
    return polygon;
}

Polygon uncrossed(std::size_t count, unsigned steps, std::mt19937& random) {
    Polygon polygon;
    std::set<std::pair<double, double>> taken;
    while (polygon.size() < count) {
        const glm::dvec2 point = steps == 0 ? glm::dvec2(uniform(random, 0, 1), uniform(random, 0, 1))
                                            : glm::dvec2(random() % steps, random() % steps);
        if (taken.emplace(point.x, point.y).second) polygon.push_back(point);
    }
    const auto step = [&] {
        for (std::size_t i = 0; i + 1 < count; ++i)
            for (std::size_t j = i + 2; j < count; ++j) {
                const glm::dvec2 a = polygon[i], b = polygon[i + 1];
                const glm::dvec2 c = polygon[j], d = polygon[(j + 1) % count];
                if (a == d || !do_meet(a, b, c, d)) continue;
                const double saved =
                    glm::distance(a, b) + glm::distance(c, d) - glm::distance(a, c) - glm::distance(b, d);
                if (saved < 1e-9) continue;
                std::reverse(polygon.begin() + static_cast<std::ptrdiff_t>(i + 1),
                             polygon.begin() + static_cast<std::ptrdiff_t>(j + 1));
                return true;
            }
        return false;
    };
    while (step()) {
    }
    return polygon;
}

Polygon grown(std::size_t squares, std::mt19937& random) {
    using Place = std::pair<int, int>;
    std::set<Place> inside{{0, 0}};
    const auto is_in = [&](int x, int y) { return inside.contains({x, y}); };
    // A square may be added if its present neighbors form one connected row around it. Then no hole closes
    // and no corner touches.
    const auto may_add = [&](int x, int y) {
        constexpr std::array<Place, 8> around{
            {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}}};
        int changes = 0;
        for (std::size_t i = 0; i < 8; ++i) {
            const auto [ax, ay] = around[i];
            const auto [bx, by] = around[(i + 1) % 8];
            changes += is_in(x + ax, y + ay) != is_in(x + bx, y + by);
        }
        const bool has_side = is_in(x + 1, y) || is_in(x - 1, y) || is_in(x, y + 1) || is_in(x, y - 1);
        return changes == 2 && has_side;
    };
    while (inside.size() < squares) {
        auto from = inside.begin();
        std::advance(from, random() % inside.size());
        constexpr std::array<Place, 4> ways{{{1, 0}, {-1, 0}, {0, 1}, {0, -1}}};
        const Place way = ways[random() % 4];
        const Place to{from->first + way.first, from->second + way.second};
        if (!inside.contains(to) && may_add(to.first, to.second)) inside.insert(to);
    }
    std::map<Place, Place> next;
    for (const auto& [x, y] : inside) {
        if (!is_in(x, y - 1)) next[{x, y}] = {x + 1, y};
        if (!is_in(x + 1, y)) next[{x + 1, y}] = {x + 1, y + 1};
        if (!is_in(x, y + 1)) next[{x + 1, y + 1}] = {x, y + 1};
        if (!is_in(x - 1, y)) next[{x, y + 1}] = {x, y};
    }
    Polygon polygon;
    const Place first = next.begin()->first;
    Place at = first;
    do {
        polygon.emplace_back(at.first, at.second);
        at = next.at(at);
    } while (at != first);
    return polygon;
}

Polygon comb(std::size_t count) {
    Polygon polygon{{0, -1}, {static_cast<double>(count), -1}};
    for (std::size_t i = 2; i < count; ++i)
        polygon.emplace_back(static_cast<double>(count - i), i % 2 == 0 ? 0 : 100);
    return polygon;
}

Polygon spiral(std::size_t count) {
    Polygon polygon;
    const std::size_t half = count / 2;
    const auto at = [](double radius, double angle) {
        return radius * glm::dvec2(std::cos(angle), std::sin(angle));
    };
    const auto angle_of = [](std::size_t i) { return 0.1 * static_cast<double>(i); };
    for (std::size_t i = 0; i < half; ++i) polygon.push_back(at(2 + angle_of(i), angle_of(i)));
    for (std::size_t i = count - half; i-- > 0;) polygon.push_back(at(3 + angle_of(i), angle_of(i)));
    return turned_over(polygon);
}

Polygon zigzag(std::size_t count) {
    Polygon polygon;
    const std::size_t half = count / 2;
    const auto at = [](std::size_t i, double offset) {
        const auto along = static_cast<double>(i);
        const double across = offset + (i % 2 == 0 ? 0.0 : 3.0);
        return glm::dvec2(along + across, along - across);
    };
    for (std::size_t i = 0; i < half; ++i) polygon.push_back(at(i, 0));
    for (std::size_t i = count - half; i-- > 0;) polygon.push_back(at(i, -1));
    return polygon;
}

Polygon flower(std::size_t petals) {
    Polygon polygon;
    const auto count = static_cast<double>(petals);
    for (std::size_t petal = 0; petal < petals; ++petal) {
        const auto at = [&](double part) {
            const double angle = 2 * pi * (static_cast<double>(petal) + part) / count;
            return glm::dvec2(std::cos(angle), std::sin(angle));
        };
        polygon.insert(polygon.end(), {glm::dvec2(0), at(0), at(0.5)});
    }
    return polygon;
}

Polygon curtain(std::size_t slits) {
    const auto width = static_cast<double>(slits + 1);
    Polygon polygon{{0, 0}, {width, 0}, {width, 10}};
    for (std::size_t slit = slits; slit > 0; --slit) {
        const auto x = static_cast<double>(slit);
        polygon.insert(polygon.end(), {{x + 0.5, 10}, {x, 0}, {x + 0.25, 10}});
    }
    polygon.emplace_back(0, 10);
    return polygon;
}

Polygon keyholes(unsigned holes) {
    const double size = 4 * holes + 1;
    Polygon polygon{{0, 0}, {size, 0}, {size, size}, {0, size}};
    // From top to bottom along the left side, where each seam begins.
    for (unsigned hole = holes; hole-- > 0;) {
        const double y = 4 * hole + 2;
        const double x = 2 + hole;
        const std::array<glm::dvec2, 7> seam{
            {{0, y}, {x, y}, {x, y + 1}, {x + 1, y + 1}, {x + 1, y}, {x, y}, {0, y}}};
        polygon.insert(polygon.end(), seam.begin(), seam.end());
    }
    return polygon;
}

Polygon maze(int size, std::size_t squares, std::mt19937& random) {
    using Place = std::pair<int, int>;
    struct Wall {
        Place square;
        std::size_t side;
        bool operator==(const Wall&) const = default;
    };
    // By side, counterclockwise from the lower side.
    constexpr std::array<Place, 4> beyond{{{0, -1}, {1, 0}, {0, 1}, {-1, 0}}};
    constexpr std::array<Place, 4> begin{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
    const auto other = [&](Place square, std::size_t side) {
        return Place{square.first + beyond[side].first, square.second + beyond[side].second};
    };
    std::vector<Place> reached{{0, 0}};
    std::set<Place> is_reached{{0, 0}};
    std::set<std::pair<Place, Place>> doors;
    squares = std::min(squares, static_cast<std::size_t>(size) * static_cast<std::size_t>(size));
    while (reached.size() < squares) {
        const Place from = reached[random() % reached.size()];
        const Place to = other(from, random() % 4);
        const bool is_in = std::min(to.first, to.second) >= 0 && std::max(to.first, to.second) < size;
        if (!is_in || !is_reached.insert(to).second) continue;
        reached.push_back(to);
        doors.insert({from, to});
        doors.insert({to, from});
    }
    Polygon polygon;
    const Wall first{{0, 0}, 0};
    Wall wall = first;
    do {
        polygon.emplace_back(wall.square.first + begin[wall.side].first,
                             wall.square.second + begin[wall.side].second);
        wall.side = (wall.side + 1) % 4;
        while (doors.contains({wall.square, other(wall.square, wall.side)}))
            wall = {other(wall.square, wall.side), (wall.side + 3) % 4};
    } while (wall != first);
    return polygon;
}

double doubled_area(const Polygon& polygon) {
    double sum = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i)
        sum += turn(polygon[0], polygon[i], polygon[(i + 1) % polygon.size()]);
    return sum;
}

bool is_inside(const Polygon& polygon, glm::dvec2 point) {
    bool inside = false;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec2 a = polygon[i];
        const glm::dvec2 b = polygon[(i + 1) % polygon.size()];
        if ((a.y > point.y) == (b.y > point.y)) continue;
        if (point.x < a.x + (point.y - a.y) / (b.y - a.y) * (b.x - a.x)) inside = !inside;
    }
    return inside;
}

bool do_edges_cross(const Polygon& polygon) {
    const std::size_t count = polygon.size();
    const auto are_apart = [](double s, double t) { return (s < 0 && t > 0) || (s > 0 && t < 0); };
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t j = i + 1; j < count; ++j) {
            const glm::dvec2 a = polygon[i], b = polygon[(i + 1) % count];
            const glm::dvec2 c = polygon[j], d = polygon[(j + 1) % count];
            if (are_apart(turn(a, b, c), turn(a, b, d)) && are_apart(turn(c, d, a), turn(c, d, b)))
                return true;
        }
    return false;
}

std::string division_fault(const Polygon& polygon, std::span<const Triangle> triangles, int samples,
                           std::mt19937& random) {
    const std::size_t count = polygon.size();
    if (triangles.size() + 2 != count)
        return fmt::format("{} triangles for {} corners", triangles.size(), count);

    std::set<std::pair<Index, Index>> edges;
    for (const Triangle& t : triangles)
        for (std::size_t i = 0; i < 3; ++i) {
            if (t[i] >= count) return fmt::format("corner {} of {}", t[i], count);
            if (!edges.emplace(t[i], t[(i + 1) % 3]).second)
                return fmt::format("edge {} {} twice", t[i], t[(i + 1) % 3]);
        }
    for (Index i = 0; i < count; ++i)
        if (edges.erase({i, static_cast<Index>((i + 1) % count)}) == 0)
            return fmt::format("no triangle at the edge behind corner {}", i);
    for (const auto& [a, b] : edges)
        if (!edges.contains({b, a})) return fmt::format("no triangle beyond edge {} {}", a, b);

    glm::dvec2 least = polygon.front();
    glm::dvec2 most = polygon.front();
    for (const glm::dvec2& point : polygon) {
        least = {std::min(least.x, point.x), std::min(least.y, point.y)};
        most = {std::max(most.x, point.x), std::max(most.y, point.y)};
    }
    const double size = std::max(most.x - least.x, most.y - least.y);
    const double area = doubled_area(polygon);
    const double sign = area < 0 ? -1 : 1;
    double sum = 0;
    const double rounding = 1e-7 * size * size;
    for (const auto& [a, b, c] : triangles) {
        const double part = sign * turn(polygon[a], polygon[b], polygon[c]);
        if (part < -rounding) return fmt::format("triangle {} {} {} is turned over by {}", a, b, c, part);
        sum += std::max(part, 0.0);
    }
    if (std::abs(sum - sign * area) > rounding)
        return fmt::format("areas of {}, together {}", sign * area / 2, sum / 2);

    for (int sample = 0; sample < samples; ++sample) {
        const glm::dvec2 point(uniform(random, least.x, most.x), uniform(random, least.y, most.y));
        int hits = 0;
        bool is_close = false;
        for (const auto& [a, b, c] : triangles) {
            const std::array<double, 3> sides{sign * turn(polygon[a], polygon[b], point),
                                              sign * turn(polygon[b], polygon[c], point),
                                              sign * turn(polygon[c], polygon[a], point)};
            const double side = *std::ranges::min_element(sides);
            is_close = is_close || std::abs(side) < rounding;
            hits += side > 0;
        }
        if (!is_close && hits != is_inside(polygon, point))
            return fmt::format("{} triangles at ({}, {})", hits, point.x, point.y);
    }
    return {};
}

std::vector<glm::dvec3> in_space(const Polygon& polygon) {
    std::vector<glm::dvec3> corners;
    corners.reserve(polygon.size());
    for (const glm::dvec2& point : polygon) corners.emplace_back(point, 0);
    return corners;
}

std::vector<glm::dvec3> in_random_plane(const Polygon& polygon, std::mt19937& random) {
    std::normal_distribution<double> normal;
    const auto direction = [&] {
        return glm::normalize(glm::dvec3(normal(random), normal(random), normal(random)));
    };
    const glm::dvec3 x = direction();
    const glm::dvec3 y = glm::normalize(glm::cross(x, direction()));
    const glm::dvec3 offset = uniform(random, 0, 10) * direction();
    const double scale = std::exp(uniform(random, -5, 5));
    std::vector<glm::dvec3> corners;
    corners.reserve(polygon.size());
    for (const glm::dvec2& point : polygon) corners.push_back(scale * (point.x * x + point.y * y + offset));
    return corners;
}

}  // namespace interleaf
