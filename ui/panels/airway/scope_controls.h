#pragma once

#include "models/station/flown_endoscope.h"

#include <QWidget>

class QComboBox;
class QToolButton;

namespace carina
{

/// Beneath a scope's picture: which camera it is of, and whether it is on the whole screen; and
/// while an endoscope is flown, buttons that fly it, for who has no keyboard.
class ScopeControls : public QWidget
{
    Q_OBJECT

public:
    /// @pre the endoscope outlives it
    ScopeControls(FlownEndoscope& endoscope, bool isOnWholeScreen, QWidget* parent = nullptr);

    /// Shows the choice as it is, which another panel may have made, and whether there is one.
    /// @param canFly the patient has an airway to be flown through
    void refresh(bool canFly);

Q_SIGNALS:
    void wholeScreenToggled();
    /// The other camera was chosen.
    void cameraChosen();

private:
    void addFlight();

    FlownEndoscope& m_endoscope;
    QComboBox* m_camera;
    QToolButton* m_whole;
    QWidget* m_flight;
};

} // namespace carina
