#pragma once

#include <atomic>
#include <optional>

#include "case/case.hpp"
#include "proof/certificate.hpp"
#include "result/adjudication.hpp"

namespace zenosphere {

/// What exact arithmetic proves about a case of rods; nothing for other cases.
///
/// Such a case has rods (dimension 1) that are written in it, one constant restitution, and neither
/// walls nor gravity nor a drive. Every number means its shortest decimal text, as in a run of any
/// precision.
std::optional<Certificate> certificate_of(const Case& values, const std::atomic<bool>* interrupt);

/// Lets a proof decide: a collapse that is proven becomes the finding of the strongest approach;
/// where the rods are proven to fly apart, or to collide so often and no more until run.time, an
/// approach that looked singular or was undecided is a near-collapse.
///
/// \param values  the case of the certificate
void apply(const Certificate& certificate, const Case& values, Adjudication& adjudication);

}  // namespace zenosphere
