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

/// The content of the report of a registration: operator, method, expected error, and errors
/// measured at points that were not used in the fit. Texts are translated; empty or unknown values
/// are left out, and so is a section without content.
struct RegistrationReport {
    enum class Verdict : std::uint8_t { NotVerified, NotGoodEnough, Verified };

    /// The tip of the stylus, from pivot calibration.
    struct Stylus {
        double rms_mm = 0.0;         ///< RMS distance of the tip from the divot
        double uncertainty_mm = 0.0; ///< RMS error of the tip
        int poses = 0;
        QString coverage{}; ///< range of rotation, in words
        QString date{};     ///< ISO 8601
    };

    struct Landmark {
        QString name{};
        std::optional<double> spread_mm{};   ///< of the tip during the touch
        std::optional<double> residual_mm{}; ///< after the fit
        std::optional<double> expected_mm{}; ///< RMS expected of the residual
        std::optional<double> leftOut_mm{};  ///< its distance from the fit of all others
    };

    /// The FLE estimated from the residuals.
    struct Localisation {
        double rms_mm = 0.0;
        double limit_mm = 0.0; ///< 95 % upper confidence limit
    };

    /// The TRE expected at a target.
    struct Target {
        QString name{};
        double rms_mm = 0.0;
        double bound_mm = 0.0;      ///< of 95 %
        QString weakestDirection{}; ///< in words
    };

    /// A point that was not used in the fit, touched to measure the TRE.
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
    std::optional<double> bound_mm{}; ///< 95 % bound expected at the worst target
    QStringList notes{};              ///< warnings to the reader
    std::vector<CheckedPoint> checked{};
    std::vector<Target> targets{};
    std::vector<Landmark> landmarks{};
    std::optional<double> fre_mm{}; ///< RMS of the residuals
    std::optional<Localisation> fle{};
    std::optional<Stylus> stylus{};
    QImage picture{}; ///< of the anatomy with the map of the expected error; may be null
    QString caption{};
};

/// Writes the report as an A4 PDF that is readable in grey: numbers in tables with bars beside
/// them. The file is replaced atomically: if the program is killed, the old or the new file is
/// complete.
///
/// @returns FileUnwritable with the path; an existing file is then unchanged.
/// @pre there is a QGuiApplication, for its fonts.
[[nodiscard]] Result<void> writeRegistrationReport(const std::filesystem::path& file,
                                                   const RegistrationReport& report);

} // namespace carina
