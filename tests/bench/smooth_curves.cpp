// SPDX-License-Identifier: MIT
// measured_duels: ways tried, then turns taken, in children.
#include "hard_edged.h"
#include "bench/smooth_curves.h"

#include "bench/embree_smooth_peer.h"
#include "bench/mesa_smooth_peer.h"
#include "bench/picture_judge.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <utility>

namespace {

/// Turns, and a side's frames in a turn: as many as fit into some time. The first finds its caches
/// cold and is not counted, unless it takes so long that they do not matter.
constexpr int turns = 3, most_frames = 5;
constexpr double turn_ms = 150;
constexpr int trial_frames = 5;

double milliseconds(const std::function<void()>& draw) {
    const auto start = std::chrono::steady_clock::now();
    draw();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
        .count();
}

double median(std::vector<double> ms) {
    std::ranges::sort(ms);
    return ms[ms.size() / 2];
}

/// One that takes turns: draw() returns a frame's milliseconds.
struct contender {
    std::function<double()> draw;
    std::function<smooth_error()> error;
    std::vector<double> ms = {};

    void take_turn() {
        double spent = draw();
        if (spent >= turn_ms)
            ms.push_back(spent);
        for (int i = 0; i < most_frames && spent < turn_ms; ++i) {
            ms.push_back(draw());
            spent += ms.back();
        }
    }
};

std::unique_ptr<mesa_smooth_peer> open_mesa(l3d_size size) {
    std::string why;
    auto peer = mesa_smooth_peer::open(size, why);
    if (!peer)
        throw std::runtime_error(why);
    return peer;
}

std::unique_ptr<embree_smooth_peer> open_embree(const smooth_scenery& of, std::size_t mesh) {
    std::string why;
    auto peer = embree_smooth_peer::open(of.meshes[mesh], of.view->camera, of.size, why);
    if (!peer)
        throw std::runtime_error(why);
    return peer;
}

/// A rival's contenders, one a mesh. Lives: as long as they are used.
class rival_side {
public:
    virtual ~rival_side() = default;
    virtual std::vector<contender> contenders() = 0;
};

class mesa_side : public rival_side {
public:
    mesa_side(const smooth_scenery& of, mesa_fineness fineness)
        : of_(of), fineness_(fineness), peer_(open_mesa(of.size)) {
        for (const peer_mesh& mesh : of.meshes)
            meshes_.push_back(peer_->mesh(mesh, of.view->camera));
    }

    std::vector<contender> contenders() override {
        std::vector<contender> result;
        for (const auto& mesh : meshes_) {
            const auto draw = [this, &mesh] { peer_->draw(*mesh, fineness_); };
            result.push_back({[draw] { return milliseconds(draw); },
                              [this, draw] {
                                  draw();
                                  return of_.judge(peer_->picture());
                              }});
        }
        return result;
    }

private:
    const smooth_scenery& of_;
    mesa_fineness fineness_;
    std::unique_ptr<mesa_smooth_peer> peer_;
    std::vector<std::unique_ptr<mesa_mesh>> meshes_;
};

class embree_side : public rival_side {
public:
    embree_side(const smooth_scenery& of, int threads, int rays)
        : of_(of), rays_(rays), workers_(threads) {
        for (std::size_t i = 0; i < of.meshes.size(); ++i)
            peers_.push_back(open_embree(of, i));
    }

    std::vector<contender> contenders() override {
        std::vector<contender> result;
        for (const auto& peer : peers_) {
            const auto draw = [this, &peer] { peer->draw(workers_, rays_); };
            result.push_back({[draw] { return milliseconds(draw); },
                              [this, &peer, draw] {
                                  draw();
                                  return of_.judge(greys_of(peer->picture()));
                              }});
        }
        return result;
    }

private:
    const smooth_scenery& of_;
    int rays_;
    l3d_workers workers_;
    std::vector<std::unique_ptr<embree_smooth_peer>> peers_;
};

std::unique_ptr<rival_side> side_of(const smooth_duel& duel, int threads) {
    switch (duel.rival) {
    case smooth_rival::mesa_samples:
        return std::make_unique<mesa_side>(*duel.of, mesa_fineness::samples);
    case smooth_rival::mesa_pixels:
        return std::make_unique<mesa_side>(*duel.of, mesa_fineness::pixels);
    case smooth_rival::embree:
        break;
    }
    return std::make_unique<embree_side>(*duel.of, threads, duel.way.embree_rays);
}

std::vector<contender> our_contenders(std::vector<std::unique_ptr<bench_frame>>& frames,
                                      const smooth_judge& judge) {
    std::vector<contender> result;
    for (const auto& frame : frames)
        result.push_back({[&frame] { return frame->draw(); },
                          [&frame, &judge] {
                              frame->hash();
                              return judge(greys_of(frame->pixels()));
                          }});
    return result;
}

/// What comes through a pipe of each contender, ours first.
constexpr std::size_t numbers_of_a_point = 4;

std::vector<double> fight(const l3d_patch_model& model, const smooth_duel& duel, int threads) {
    const l3d_patch_scene scene(model);
    std::vector<std::unique_ptr<bench_frame>> frames;
    for (const smooth_point& p : duel.ours) {
        l3d_afd_settings settings = hard_edged();
        settings.tolerance = p.tolerance;
        settings.threads = threads;
        settings.antialias = true;
        frames.push_back(
            std::make_unique<bench_frame>(scene, duel.of->view->camera, duel.of->size, settings));
    }
    const auto theirs = side_of(duel, threads);
    std::vector<contender> all = our_contenders(frames, duel.of->judge);
    std::ranges::move(theirs->contenders(), std::back_inserter(all));
    for (int turn = 0; turn < turns; ++turn)
        for (contender& c : all)
            c.take_turn();
    std::vector<double> result;
    for (contender& c : all) {
        const smooth_error error = c.error();
        result.insert(result.end(), {error.all, error.edges, median(c.ms), std::ranges::min(c.ms)});
    }
    return result;
}

/// Keeps a way if it is the fastest so far.
void keep_faster(peer_choice& best, peer_choice way, double ms) {
    way.ms = ms;
    if (best.ms == 0 || way.ms < best.ms)
        best = way;
}

double trial_ms(const std::function<void()>& draw) {
    std::vector<double> ms;
    for (int i = 0; i <= trial_frames; ++i)
        if (const double once = milliseconds(draw); i > 0)
            ms.push_back(once);
    return median(ms);
}

void try_mesa(std::span<smooth_duel> duels, int threads) {
    for (const peer_choice& way : mesa_ways(threads)) {
        const std::vector<double> ms = in_child(setting_of(way), [&] {
            std::vector<double> result;
            for (const smooth_duel& d : duels) {
                const auto peer = open_mesa(d.of->size);
                const auto mesh =
                    peer->mesh(d.of->meshes[d.of->meshes.size() / 2], d.of->view->camera);
                const auto fineness = d.rival == smooth_rival::mesa_samples ? mesa_fineness::samples
                                                                            : mesa_fineness::pixels;
                result.push_back(trial_ms([&] { peer->draw(*mesh, fineness); }));
            }
            return result;
        });
        for (std::size_t i = 0; i < duels.size(); ++i)
            keep_faster(duels[i].way, way, ms.at(i));
    }
}

void try_embree(smooth_duel& duel, int threads) {
    constexpr std::array packets{8, 16};
    const std::vector<double> ms = in_child({}, [&] {
        const auto peer = open_embree(*duel.of, duel.of->meshes.size() / 2);
        l3d_workers workers(threads);
        std::vector<double> result;
        for (const int rays : packets)
            result.push_back(trial_ms([&] { peer->draw(workers, rays); }));
        return result;
    });
    for (std::size_t i = 0; i < packets.size(); ++i)
        keep_faster(duel.way, {.embree_rays = packets[i]}, ms.at(i));
}

void read(std::span<const double> numbers, smooth_duel& duel) {
    std::size_t next = 0;
    for (auto* const side : {&duel.ours, &duel.theirs})
        for (smooth_point& p : *side) {
            const auto of = numbers.subspan(next).first<numbers_of_a_point>();
            next += numbers_of_a_point;
            p.error = {of[0], of[1]};
            p.ms = of[2];
            p.least_ms = of[3];
        }
}

} // namespace

const char* name_of(smooth_rival rival) {
    switch (rival) {
    case smooth_rival::mesa_samples:
        return "llvmpipe, 4 samples";
    case smooth_rival::mesa_pixels:
        return "llvmpipe, 4 x 4 pixels";
    case smooth_rival::embree:
        break;
    }
    return "Embree, 16 rays";
}

std::optional<double> time_at(std::span<const smooth_point> curve, double smooth_error::*over,
                              double error) {
    std::optional<double> best;
    const auto offer = [&](double ms) { best = best ? std::min(*best, ms) : ms; };
    for (const smooth_point& p : curve)
        if (p.error.*over <= error)
            offer(p.ms);
    for (std::size_t i = 1; i < curve.size(); ++i) {
        const smooth_point &a = curve[i - 1], &b = curve[i];
        const double from = a.error.*over, to = b.error.*over;
        if (error < std::min(from, to) || error > std::max(from, to) || from == to)
            continue;
        const double share = std::log(error / from) / std::log(to / from);
        offer(a.ms * std::pow(b.ms / a.ms, share));
    }
    return best;
}

const smooth_point& most_exact(std::span<const smooth_point> curve, double smooth_error::*over) {
    return *std::ranges::min_element(curve, {},
                                     [&](const smooth_point& p) { return p.error.*over; });
}

std::vector<smooth_duel> measured_duels(const l3d_patch_model& model,
                                        std::span<const smooth_scenery> sceneries,
                                        std::span<const double> tolerances, int threads) {
    std::vector<smooth_duel> duels;
    for (const smooth_rival rival : smooth_rivals) // llvmpipe's first
        for (const smooth_scenery& of : sceneries) {
            smooth_duel& duel = duels.emplace_back(smooth_duel{&of, rival, {}, {}, {}});
            for (const double tolerance : tolerances)
                duel.ours.push_back({tolerance, 0, {}, 0, 0});
            for (std::size_t i = 0; i < of.meshes.size(); ++i)
                duel.theirs.push_back({of.mesh_tolerances[i], of.meshes[i].triangles(), {}, 0, 0});
        }
    const std::size_t of_mesa = 2 * sceneries.size();
    try_mesa(std::span(duels).first(of_mesa), threads);
    for (smooth_duel& duel : std::span(duels).subspan(of_mesa))
        try_embree(duel, threads);
    for (smooth_duel& duel : duels) {
        const child_setting setting =
            duel.rival == smooth_rival::embree ? child_setting{} : setting_of(duel.way);
        read(in_child(setting, [&] { return fight(model, duel, threads); }), duel);
    }
    return duels;
}
