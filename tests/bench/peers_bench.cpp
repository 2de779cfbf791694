#include "bench/mesa_peer.h"
#include "bench/embree_peer.h"
#include "bench/peer_mesh.h"
#include "geom/teapot.h"
#include <algorithm>
#include <chrono>
#include <cstdio>
struct named_view { const char* name; l3d_camera camera; };
const std::array<named_view, 3> views{{
    {"full", {{3.2, 3.6, 7.4}, {0.2, 1.3, 0.0}, {0.0, 1.0, 0.0}, 38, 0.1, 1e13}},
    {"closeup", {{1.2, 2.6, 4.4}, {-0.3, 1.5, 0.0}, {0.0, 1.0, 0.0}, 45, 0.1, 1e13}},
    {"top", {{1.5, 7.5, 3.0}, {0.2, 1.2, 0.0}, {0.0, 1.0, 0.0}, 35, 0.1, 1e13}},
}};
using clk = std::chrono::steady_clock;
double ms_since(clk::time_point t){ return std::chrono::duration<double,std::milli>(clk::now()-t).count(); }
int main(int argc, char** argv){
    std::string why;
    const auto model = l3d_patch_model::from_bpt(l3d_teapot_bpt(), "teapot.bpt", why);
    auto gl = mesa_peer::open(why);
    if (!gl) { puts(why.c_str()); return 1; }
    puts(gl->renderer().c_str()); auto em = embree_peer::open(why); l3d_workers one(1), two(2);
    double tols[] = {0.5, 0.25, 0.1};
    l3d_size size{1024,768};
    if (argc>1) size = {atoi(argv[1]), atoi(argv[2])};
    for (double tol : tols) for (auto& v : views) {
        mesh_wish wish{*model, v.camera, size, tol, {0.4,0.8,0.45}};
        for (auto make : {adaptive_mesh, thinned_mesh}) {
            auto t0 = clk::now();
            peer_mesh m = make(wish);
            double plan = ms_since(t0);
            printf("%-8s %.2f %-9s err %.4f verts %6zu tris %6zu plan %.0f ms:", v.name, tol, m.kind.c_str(), m.error, m.vertices(), m.triangles(), plan);
            for (unsigned fmt : {0x8CACu}) {
                mesa_peer::state st; st.depth_format = fmt;
                gl->prepare(m, v.camera, size, st);
                std::vector<double> t;
                for (int i=0;i<34;++i){ auto s=clk::now(); gl->draw(); if(i>2) t.push_back(ms_since(s)); }
                std::ranges::sort(t); printf(" %.2f", t[0]);
            }
            em->prepare(m, v.camera, size); printf(" | embree");
            for (auto* w : {&one,&two}) { std::vector<double> t; for (int i=0;i<9;++i){ auto s=clk::now(); em->draw(*w); if(i>1) t.push_back(ms_since(s)); } std::ranges::sort(t); printf(" %.2f", t[0]); }
            { long d=0,c=0; auto p=gl->picture(); for(int y=0;y<size.height;++y) for(int x=0;x<size.width;++x){ int e=em->picture().row(y)[x]&255, g=p[size_t(y)*size.width+x]; d+= (e!=0)!=(g!=0); c+= abs(e-g)>3 && e && g; } printf(" differ %ld %ld", d, c); }
            puts("");
        }
    }
}
