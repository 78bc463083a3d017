#pragma once

#include "engine/core/session_time.h"

#include <QListView>

namespace carina
{

class IntubationTimeline;

/// The steps of an intubation beneath the patient: the last kShownSteps in sight, the newest
/// lowest, and all of them by scrolling. Hidden before there is any. A screen reader hears each new
/// step.
class IntubationLine : public QListView
{
    Q_OBJECT

public:
    static constexpr int kShownSteps = 3;

    explicit IntubationLine(QWidget* parent = nullptr);

    /// @pre the timeline outlives the list.
    void setTimeline(IntubationTimeline& timeline);
    /// Chooses the step that was the latest at a moment, brings it into sight, and has the
    /// keyboard.
    void choose(SessionTime moment);

    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override { return sizeHint(); }

private:
    void follow();

    IntubationTimeline* m_timeline = nullptr;
    QString m_newest;
};

} // namespace carina
