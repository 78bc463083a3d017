#pragma once

#include "apps/lab/command/words.h"
#include "engine/geometry/fit/weighted_fit.h"
#include "engine/registration/error/target_error.h"

#include <QString>

#include <string>
#include <vector>

namespace carina::lab
{

/// Landmarks or targets of a CSV file, in its order.
struct NamedPlaces {
    std::vector<std::string> names;
    std::vector<LandmarkError> places; ///< covariances 0 where none were asked for
};

/// Touched landmarks of a CSV file, in its order.
struct NamedPairs {
    std::vector<std::string> names;
    std::vector<UncertainPair> pairs; ///< covariances 0 where none were asked for

    [[nodiscard]] std::vector<LandmarkPair> unweighted() const;
};

/// Reads the columns name, ax, ay, az (mm), and with covariances cxx, cyy, czz, cxy, cxz, cyz
/// (mm^2, along the axes of A).
/// @returns what CsvTable returns.
[[nodiscard]] Result<NamedPlaces> readPlaces(const QString& file, bool withCovariances);

/// The same with mx, my, mz (mm), where each was touched on the manikin.
/// @returns FileMalformed, as a sentence, for a name that stands there twice, too.
[[nodiscard]] Result<NamedPairs> readPairs(const QString& file, bool withCovariances);

/// The millimetres given for an option; `otherwise` where it is not given.
/// @returns OutOfRange, as a sentence, where they are no positive number.
[[nodiscard]] Result<Length> positiveMillimetres(const Words& words, const Option& option,
                                                 Length otherwise);

} // namespace carina::lab
