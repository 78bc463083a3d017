#pragma once

#include "engine/core/result.h"

#include <QImage>
#include <QString>
#include <QStringList>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

namespace carina
{

/// What a registration is reported to be: by whom, how it was made, how wrong it may be, and what
/// was found at points that had no part in the fit. Words come translated; what is empty or not
/// known is left out, and so is a section without content.
struct RegistrationReport {
    enum class Verdict : std::uint8_t { NotVerified, NotGoodEnough, Verified };

    /// The tip of the stylus, from pivot calibration.
    struct Stylus {
        double rms_mm = 0.0;         ///< of the tip's distances from the divot
        double uncertainty_mm = 0.0; ///< RMS error of the tip
        int poses = 0;
        QString coverage{}; ///< how far it was turned, in words
        QString date{};     ///< ISO 8601
    };

    struct Landmark {
        QString name{};
        std::optional<double> spread_mm{};   ///< of the tip while it touched
        std::optional<double> residual_mm{}; ///< after the fit
        std::optional<double> expected_mm{}; ///< what the residual is expected to be (RMS)
        std::optional<double> leftOut_mm{};  ///< its distance from the fit of all others
    };

    /// The FLE, which the residuals tell.
    struct Localisation {
        double rms_mm = 0.0;
        double limit_mm = 0.0; ///< what the true one is below with 95 %
    };

    /// The TRE that is expected at a place that matters.
    struct Target {
        QString name{};
        double rms_mm = 0.0;
        double bound_mm = 0.0;      ///< of 95 %
        QString weakestDirection{}; ///< in words
    };

    /// A point that had no part in the fit, touched to see how wrong the registration is.
    struct CheckedPoint {
        QString name{};
        double error_mm = 0.0; ///< measured
        double bound_mm = 0.0; ///< of 95 %, expected

        [[nodiscard]] bool isWithin() const { return error_mm <= bound_mm; }
    };

    QString siteFile{};
    QString patient{};
    QString manikin{};
    QString tracker{};
    QString operatorName{};
    QString date{}; ///< ISO 8601
    Verdict verdict = Verdict::NotVerified;
    QString judged{};                 ///< when the verdict was recorded, and by whom
    std::optional<double> bound_mm{}; ///< of 95 %, expected at the worst target
    QStringList notes{};              ///< what a reader is warned of
    std::vector<CheckedPoint> checked{};
    std::vector<Target> targets{};
    std::vector<Landmark> landmarks{};
    std::optional<double> fre_mm{}; ///< RMS of the residuals
    std::optional<Localisation> fle{};
    std::optional<Stylus> stylus{};
    QImage picture{}; ///< of the anatomy with the expected error on it; may be null
    QString caption{};
};

/// Writes it as a PDF on A4, to be read in grey as well: numbers in tables, and beside them bars.
/// Whenever the program is killed, the file is whole: the old or the new one.
///
/// @returns FileUnwritable, which leaves a file that is there as it was; the detail names it.
/// @pre there is a QGuiApplication, for its fonts.
[[nodiscard]] Result<void> writeRegistrationReport(const std::filesystem::path& file,
                                                   const RegistrationReport& report);

} // namespace carina
