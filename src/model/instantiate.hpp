#pragma once

/// Calls `instantiate(Dim, Real)` for each combination that the program is built with.
///
/// The engine is a template; its code is compiled here and nowhere else.
#define ZENOSPHERE_FOR_EACH_ENGINE(instantiate) instantiate(3, double)
