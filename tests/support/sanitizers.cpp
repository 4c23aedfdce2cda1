// What the sanitizers are told, wherever and however a test is started.
#ifdef __SANITIZE_ADDRESS__

extern "C" {

const char* __asan_default_options() {
#ifdef OFFING_WHOLE_STACKS
  // Through libraries without frame pointers, which the suppressions need; too slow for a driver
  // that compiles shaders.
  return "detect_stack_use_after_return=1:strict_string_checks=1:fast_unwind_on_malloc=0";
#else
  return "detect_stack_use_after_return=1:strict_string_checks=1";
#endif
}

const char* __ubsan_default_options() { return "print_stacktrace=1"; }

const char* __lsan_default_suppressions() {
  return
      // A damaged PNG: libpng leaves by longjmp past OpenImageIO's half-made error message.
      "leak:PNGInput::PngReadCallback\n"
#ifndef OFFING_WHOLE_STACKS
      // The same where the stack ends inside the library, before that function.
      "leak:libOpenImageIO.so\n"
#endif
      // Mesa keeps 56 bytes or so of each context's compiler.
      "leak:swrast_dri.so\n"
      "leak:libgallium\n";
}

// The check for leaks comes last, when the driver would be unloaded and its frames without a name.
int dlclose(void*) { return 0; }
}

#endif
