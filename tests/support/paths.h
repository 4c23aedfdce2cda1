#pragma once
#include <filesystem>

namespace offing::test {

/// The folder tests/ of the sources.
std::filesystem::path test_data();
/// A folder of the build that tests may write to.
std::filesystem::path test_output();

}  // namespace offing::test
