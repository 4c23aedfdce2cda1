#include "support/paths.h"

namespace offing::test {

std::filesystem::path test_data() { return OFFING_TEST_DATA; }
std::filesystem::path test_output() { return OFFING_TEST_OUTPUT; }

}  // namespace offing::test
