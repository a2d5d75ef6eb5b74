// How often a test repeats what it draws at random.

#pragma once

namespace twinbus::test {

// Of so many a quarter under a sanitizer, which is seven times as slow and looks at each round for itself.
template <class Count>
constexpr Count rounds(Count all) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  return (all + 3) / 4;
#else
  return all;
#endif
}

}  // namespace twinbus::test
