#include "support/scratch_folder.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <system_error>

#include "support/paths.h"

namespace offing::test {
namespace fs = std::filesystem;

ScratchFolder::ScratchFolder() {
  const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
  // The process as well: the same test may run from two shells.
  std::string name =
      std::string(test->test_suite_name()) + "." + test->name() + "-" + std::to_string(::getpid());
  std::replace(name.begin(), name.end(), '/', '-');  // of parametrised tests
  path_ = test_output() / name;
  fs::remove_all(path_);
  fs::create_directories(path_);
}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

}  // namespace offing::test
