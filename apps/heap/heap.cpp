// The heap of the programs with a window is jemalloc's, which is there by being linked. Blocks of
// all sizes come and go with each frame, fact and patient, and what lives on would lie between
// them; jemalloc keeps blocks of about one size together, so that the holes are found again. With
// glibc's heap a program grew without holding more.

/// Read by jemalloc before anything is allocated: pages that hold no block go back to the system
/// 2 s after they were freed, also those of threads that rest.
extern "C" {
const char* malloc_conf = "background_thread:true,dirty_decay_ms:2000,muzzy_decay_ms:0";
}
