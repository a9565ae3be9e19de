// What the thread sanitizer must not take for races: linked into every test program of that build.
//
// Libraries are not built with the sanitizer, which sees none of their synchronisation and takes every hand-over of work for a race. What
// their own code reads and writes is let pass. So is what TBB runs: the machine's own pieces of work run on plain threads there
// (ig/machine/fork_join.h), where races are told; what the databases do by TBB (reading, validating, fields of wakes) is checked only by
// results that are the same for every thread count. A mock panel lives and dies by GLib's signals, on umockdev's thread and the test's.
extern "C" const char* __tsan_default_options() { return "ignore_noninstrumented_modules=1"; }

extern "C" const char* __tsan_default_suppressions() {
    return "called_from_lib:libtbb.so\n"
           "race:tbb::\n"
           "race:libtbb.so\n"
           "race:linkdig::panel::MockPanel\n";
}
