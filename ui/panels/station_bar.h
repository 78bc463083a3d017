#pragma once

#include "models/station/stations_model.h"
#include "widgets/second_press.h"

#include <QWidget>

class QCheckBox;
class QTabBar;
class QToolButton;

namespace carina
{

/// A tab for each open station of the session, to choose the one that is shown; buttons that open,
/// name and close stations; and a switch by which changes of the patient are for all of them.
class StationBar : public QWidget
{
    Q_OBJECT

public:
    explicit StationBar(QWidget* parent = nullptr);

    /// @pre the model outlives the bar.
    void setModel(StationsModel& stations);

private:
    [[nodiscard]] QToolButton* button(const char* name, const QString& text);
    void refresh();
    void askForNew();
    void askForName();

    StationsModel* m_stations = nullptr;
    QTabBar* m_tabs;
    QToolButton* m_add;
    QToolButton* m_rename;
    QToolButton* m_close;
    QCheckBox* m_forAll;
    SecondPress m_closing; ///< of the station that is shown
};

} // namespace carina
