#include "src/runtime/resources/counters.h"

namespace snell {

std::span<const CounterName> counter_names() {
    static constexpr CounterName names[]{{"files_opened", "", &Counters::files_opened},
                                         {"bytes_read", "", &Counters::bytes_read},
                                         {"images_decoded", "", &Counters::images_decoded},
                                         {"bytes_decoded", "", &Counters::bytes_decoded},
                                         {"bytes_uploaded", "", &Counters::bytes_uploaded},
                                         {"textures", "memory.textures", &Counters::textures},
                                         {"mip_chains", "", &Counters::mip_chains},
                                         {"noise_bytes", "", &Counters::noise_bytes},
                                         {"meshes", "memory.geometries", &Counters::meshes},
                                         {"buffers", "", &Counters::buffers},
                                         {"trees", "", &Counters::trees},
                                         {"programs_compiled", "programs", &Counters::programs_compiled},
                                         {"shaders_compiled", "", &Counters::shaders_compiled},
                                         {"variants", "", &Counters::variants},
                                         {"specialised", "", &Counters::specialised},
                                         {"specialise_us", "", &Counters::specialise_us},
                                         {"images_spared", "", &Counters::images_spared},
                                         {"targets", "", &Counters::targets},
                                         {"frames", "render.frame", &Counters::frames},
                                         {"frames_skipped", "", &Counters::frames_skipped},
                                         {"passes", "", &Counters::passes},
                                         {"draws", "render.calls", &Counters::draws},
                                         {"triangles", "render.triangles", &Counters::triangles},
                                         {"lines", "render.lines", &Counters::lines},
                                         {"points", "render.points", &Counters::points},
                                         {"blended_draws", "", &Counters::blended_draws},
                                         {"specialised_draws", "", &Counters::specialised_draws},
                                         {"draws_culled", "", &Counters::draws_culled},
                                         {"uniform_uploads", "", &Counters::uniform_uploads},
                                         {"state_changes", "", &Counters::state_changes},
                                         {"stage_reads", "", &Counters::stage_reads},
                                         {"captured_primitives", "", &Counters::captured_primitives},
                                         {"captured_bytes", "", &Counters::captured_bytes},
                                         {"cube_faces", "", &Counters::cube_faces},
                                         {"convolutions", "", &Counters::convolutions},
                                         {"gpu_bytes", "", &Counters::gpu_bytes}};
    return names;
}

}  // namespace snell
