// SPDX-License-Identifier: MIT
// Named cases, random ones, ordinary ones, walks.
#include "suite.h"

#include "curved_cases.h"
#include "polygon_ways.h"
#include "slices.h"

#include "geom/real.h"
#include "raster/parallel/simd_target.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <functional>
#include <limits>
#include <mutex>
#include <optional>
#include <thread>

namespace stability {
namespace {

constexpr std::size_t listed_worst = 5, listed_violations = 100;

/// Random cases have fewer points in 100 digits, so that there can be a million.
constexpr effort named_effort{3000, 8}, random_effort{40, 2}, ordinary_effort{100'000, 8};
/// A point of degree 15 in 100 digits takes a millisecond. So only those near their bound do.
constexpr effort curved_effort{400, 2, 0.9};

/// The results, to which threads add one at a time.
class collector {
public:
    explicit collector(suite_result& into) : into_(into) {}

    void add(std::array<tally, arithmetic_count>& tallies, const test_case& c,
             const std::array<verdict, arithmetic_count>& verdicts) {
        const std::scoped_lock lock(mutex_);
        for (std::size_t a = 0; a < arithmetic_count; ++a) {
            const verdict& v = verdicts[a];
            tallies[a].add(c, v);
            if (v.what == outcome::violated)
                violate(into_.arithmetics[a] + ", " + c.group + ", " + c.name + ": " + v.reason);
            else if (into_.worst.size() < listed_worst || v.ratio > into_.worst.back().ratio)
                keep({v.ratio, into_.arithmetics[a], c.group, c.name, v.ratio_measured,
                      v.ratio_bound});
        }
    }

    void add(tally& to, const test_case& c, const verdict& v) {
        const std::scoped_lock lock(mutex_);
        to.add(c, v);
        if (v.what == outcome::violated)
            violate("polygons, " + c.group + ", " + c.name + ": " + v.reason);
    }

    void violate(const std::string& line) {
        ++into_.violation_count;
        if (into_.violations.size() < listed_violations)
            into_.violations.push_back(line);
    }

    /// A line on the standard error now and then.
    void progress(const char* what, std::uint64_t done, std::uint64_t of) {
        const std::scoped_lock lock(mutex_);
        const auto now = std::chrono::steady_clock::now();
        if (now - told_ < std::chrono::seconds(10))
            return;
        told_ = now;
        std::fprintf(stderr, "%s: %llu of %llu, %lld violations\n", what,
                     static_cast<unsigned long long>(done), static_cast<unsigned long long>(of),
                     static_cast<long long>(into_.violation_count));
    }

private:
    /// The same case is as bad in all arithmetics: once is enough.
    void keep(const worst_case& w) {
        auto& worst = into_.worst;
        for (worst_case& other : worst)
            if (other.group == w.group && other.name == w.name) {
                if (other.ratio < w.ratio)
                    other = w;
                return sort();
            }
        worst.push_back(w);
        sort();
        if (worst.size() > listed_worst)
            worst.pop_back();
    }

    void sort() {
        std::sort(into_.worst.begin(), into_.worst.end(),
                  [](const worst_case& a, const worst_case& b) { return a.ratio > b.ratio; });
    }

    suite_result& into_;
    std::mutex mutex_;
    std::chrono::steady_clock::time_point told_ = std::chrono::steady_clock::now();
};

using arithmetics = std::vector<std::unique_ptr<arithmetic>>;

/// Calls work(i, arithmetics of the thread) for i below count, on all threads.
void on_threads(int threads, std::uint64_t count, const char* what, collector& collected,
                const std::function<void(std::uint64_t, const arithmetics&)>& work) {
    std::atomic<std::uint64_t> next{0};
    const auto run = [&] {
        const arithmetics own = all_arithmetics();
        for (std::uint64_t i = next++; i < count; i = next++) {
            work(i, own);
            collected.progress(what, i, count);
        }
    };
    std::vector<std::jthread> others;
    for (int i = 1; i < threads; ++i)
        others.emplace_back(run);
    run();
}

std::array<verdict, arithmetic_count> judged(const test_case& c, const effort& how, bool picture,
                                             const arithmetics& ways) {
    std::array<verdict, arithmetic_count> result;
    judge j(c, how);
    for (std::size_t a = 0; a < arithmetic_count; ++a) {
        verdict& v = result[a];
        v = picture ? j.of_frame(*ways[a]) : j.of_points(*ways[a]);
        if (picture && j.accepted() && std::string(pipeline_arithmetic()) == ways[a]->name()) {
            const frame whole = draw_by_pipeline(*j.accepted());
            if (whole.words != j.words() || whole.counts.bound_px != v.bound)
                v.violate("l3d_pipeline_afd draws another picture");
        }
    }
    return result;
}

void run_named(suite_result& result, const extent& how_much, collector& collected) {
    const std::vector<test_case> all = named_cases();
    std::vector<const test_case*> cases;
    for (std::size_t i = 0; i < all.size(); i += how_much.every_named)
        if ((all[i].group + ": " + all[i].name).find(how_much.only) != std::string::npos)
            cases.push_back(&all[i]);
    result.named.resize(cases.size());
    on_threads(how_much.threads, cases.size(), "named cases", collected,
               [&](std::uint64_t i, const arithmetics& ways) {
                   const test_case& c = *cases[i];
                   named_result& r = result.named[i];
                   r = {c.group,
                        c.name,
                        c.tolerance,
                        is_malformed(c) ? stiffness() : stiffness_of(c),
                        judged(c, named_effort, true, ways),
                        judged_as_polygons(c)};
                   collected.add(result.named_tally, c, r.verdicts);
                   collected.add(result.polygon_tally, c, r.as_polygons);
               });
}

/// Cases that are made of seeds.
struct seeded {
    const char* name; ///< of the file of slices
    std::uint64_t count, frames;
    test_case (*make)(std::uint64_t seed);
    effort how;
    std::array<tally, arithmetic_count>& into;
};

/// In slices; those that the file has already are left out.
void run_seeded(suite_result& result, const extent& how_much, const seeded& cases,
                collector& collected) {
    std::optional<slice_file> slices;
    if (!how_much.slices.empty())
        slices.emplace(how_much.slices + '_' + cases.name + ".csv",
                       std::string("l3d_real = ") + l3d_real_name() + ' ' + l3d_simd_target());
    const std::string what = std::string(cases.name) + " cases of a slice";
    for (std::uint64_t first = 0; first < cases.count; first += slice_size) {
        if (slices && slices->has(first))
            continue;
        std::array<tally, arithmetic_count> tallies;
        const std::uint64_t count = std::min(slice_size, cases.count - first);
        on_threads(how_much.threads, count, what.c_str(), collected,
                   [&](std::uint64_t i, const arithmetics& ways) {
                       const test_case c = cases.make(first + i + 1);
                       const bool picture = first + i < cases.frames;
                       collected.add(tallies, c, judged(c, cases.how, picture, ways));
                   });
        for (std::size_t a = 0; a < arithmetic_count; ++a)
            cases.into[a].add(tallies[a]);
        if (slices && count == slice_size)
            slices->add(first, result, tallies);
    }
}

void run_parallel(suite_result& result, const extent& how_much, collector& collected) {
    on_threads(how_much.threads, how_much.parallel, "parallel projections", collected,
               [&](std::uint64_t i, const arithmetics& ways) {
                   const test_case c = parallel_case(i + 1);
                   collected.add(result.parallel_tally, c, judged(c, random_effort, true, ways));
               });
}

void run_ordinary(suite_result& result, const extent& how_much, collector& collected) {
    std::array<std::vector<double>, arithmetic_count> looseness;
    for (auto& of : looseness)
        of.resize(how_much.ordinary, std::numeric_limits<double>::infinity());
    on_threads(how_much.threads, how_much.ordinary, "ordinary patches", collected,
               [&](std::uint64_t i, const arithmetics& ways) {
                   const auto verdicts = judged(ordinary_case(i + 1), ordinary_effort, false, ways);
                   for (std::size_t a = 0; a < arithmetic_count; ++a)
                       looseness[a][i] = verdicts[a].bound / verdicts[a].measured;
               });
    result.ordinary = how_much.ordinary;
    if (how_much.ordinary == 0)
        return;
    for (std::size_t a = 0; a < arithmetic_count; ++a) {
        const auto middle =
            looseness[a].begin() + static_cast<std::ptrdiff_t>(looseness[a].size() / 2);
        std::nth_element(looseness[a].begin(), middle, looseness[a].end());
        result.median_looseness[a] = *middle;
        if (!(*middle <= most_median_looseness))
            collected.violate(result.arithmetics[a] + ": bounds of ordinary patches are " +
                              std::to_string(*middle) + " times the error in the median");
    }
}

} // namespace

void tally::add(const test_case& c, const verdict& v) {
    ++outcomes[static_cast<std::size_t>(v.what)];
    points += v.points;
    exactly += v.exactly;
    pictures += v.picture_judged;
    most_pieces = std::max(most_pieces, v.pieces);
    if (v.milliseconds > slowest_ms) {
        slowest_ms = v.milliseconds;
        slowest = c.group + ", " + c.name;
    }
    if (v.ratio > worst_ratio) {
        worst_ratio = v.ratio;
        worst = c.group + "; " + c.name;
    }
    if (v.samples > most_samples) {
        most_samples = v.samples;
        most_sampled = c.group + ", " + c.name;
    }
}

void tally::add(const tally& other) {
    for (std::size_t i = 0; i < outcomes.size(); ++i)
        outcomes[i] += other.outcomes[i];
    points += other.points;
    exactly += other.exactly;
    pictures += other.pictures;
    most_pieces = std::max(most_pieces, other.most_pieces);
    if (other.worst_ratio > worst_ratio) {
        worst_ratio = other.worst_ratio;
        worst = other.worst;
    }
    if (other.slowest_ms > slowest_ms) {
        slowest_ms = other.slowest_ms;
        slowest = other.slowest;
    }
    if (other.most_samples > most_samples) {
        most_samples = other.most_samples;
        most_sampled = other.most_sampled;
    }
}

std::int64_t tally::cases() const {
    std::int64_t sum = 0;
    for (const std::int64_t n : outcomes)
        sum += n;
    return sum;
}

suite_result run_suite(const extent& how_much) {
    const auto start = std::chrono::steady_clock::now();
    suite_result result;
    const arithmetics ways = all_arithmetics();
    for (std::size_t a = 0; a < arithmetic_count; ++a)
        result.arithmetics[a] = ways[a]->name();
    collector collected(result);
    run_named(result, how_much, collected);
    run_seeded(result, how_much,
               {"random", how_much.random, how_much.frames, random_case, random_effort,
                result.random_tally},
               collected);
    run_seeded(result, how_much,
               {"curved", how_much.curved, 0, curved_case, curved_effort, result.curved_tally},
               collected);
    run_parallel(result, how_much, collected);
    run_ordinary(result, how_much, collected);
    if (how_much.only.empty()) {
        result.walks = all_walks();
        result.curves = all_curves();
    }
    for (const curve_result& c : result.curves)
        if (!c.kept())
            collected.violate("curves, " + c.group + ", " + c.name + ": " +
                              std::to_string(c.measured) + " px off, bound " +
                              std::to_string(c.bound));
    for (const walk_result& w : result.walks)
        if (!w.kept())
            collected.violate(w.arithmetic + ", " + w.curve + ", " + std::to_string(w.steps) +
                              " steps: " + std::to_string(w.measured) + " off, bound " +
                              std::to_string(w.bound));
    result.seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return result;
}

} // namespace stability
