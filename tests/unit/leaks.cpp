// What the leak sanitizer may overlook in these tests. OpenImageIO leaves damaged PNGs by libpng's
// longjmp, past a string of its own: some 30 bytes for each such file.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() { return "leak:OpenImageIO\n"; }
