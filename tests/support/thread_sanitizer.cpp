// What the thread sanitizer must not take for races: linked into every test program of that build.
//
// TBB's library is not built with the sanitizer, which sees none of its synchronisation and takes every hand-over of work
// for a race. The machine's own pieces of work run on plain threads there (ig/machine/fork_join.h), where races are told;
// what the databases do by TBB (reading, validating, fields of wakes) is let pass, and is checked only by results that are
// the same for every thread count.
extern "C" const char* __tsan_default_suppressions() {
    return "called_from_lib:libtbb.so\n"
           "race:tbb::\n"
           "race:libtbb.so\n";
}
