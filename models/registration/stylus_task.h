#pragma once

#include "models/registration/stylus_watch.h"
#include "models/site/site_editor.h"

namespace carina
{

/// Calibrates the stylus: its tip by pivoting, which starts and ends automatically, and the axis of
/// its shaft by spinning.
class StylusTask
{
public:
    /// @pre both outlive this.
    StylusTask(SiteEditor& editor, StylusWatch& watch);

    /// The calibration of the tracked stylus; null before there is one.
    [[nodiscard]] const StylusTip* tip() const;

    /// The error with which the tracker sees the tip now (StylusWatch::expectedTipError).
    [[nodiscard]] std::optional<Length> expectedTipError() const
    {
        return m_watch.expectedTipError();
    }

    [[nodiscard]] bool isLookingForTip() const { return m_watch.use() == StylusUse::Pivot; }
    [[nodiscard]] bool isSpinning() const { return m_watch.use() == StylusUse::Spin; }
    [[nodiscard]] const PivotProgress& pivot() const { return m_watch.pivot(); }

    /// Waits for the stylus to be pivoted; an earlier calibration stays until the new one is found.
    void findTip();
    /// Collects poses for some seconds, while the stylus is spun about its shaft.
    /// @pre its tip is known.
    void findAxis();
    void stop();

    void take(const StylusNews& news);

private:
    void takeAxis(const Result<SpinCalibration>& axis);

    SiteEditor& m_editor;
    StylusWatch& m_watch;
};

} // namespace carina
