// What nearly every source includes and takes seconds to read: precompiled, once for each set of
// flags (cmake/precompiled.cmake). A source still includes all that it uses itself.
#include <mpfr.h>

#include <algorithm>
#include <boost/multiprecision/float128.hpp>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>
