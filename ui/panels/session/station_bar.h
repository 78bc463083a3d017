#pragma once

#include "models/station/stations_model.h"
#include "widgets/second_press.h"

#include <QWidget>

class QCheckBox;
class QComboBox;
class QTabBar;
class QToolButton;

namespace carina
{

/// A tab for each open station of the session, to choose the one that is shown, or a list of them
/// where there is no room for tabs; buttons that open, name and close stations; and a switch by
/// which changes of the patient are for all of them.
class StationBar : public QWidget
{
    Q_OBJECT

public:
    explicit StationBar(QWidget* parent = nullptr);

    /// @pre the model outlives the bar.
    void setModel(StationsModel& stations);

protected:
    void resizeEvent(QResizeEvent* event) override;
    void showEvent(QShowEvent* event) override;

private:
    [[nodiscard]] QToolButton* button(const char* name, const QString& text);
    void choose(int place);
    void refresh();
    void refreshTabs();
    void refreshList();
    void nameTabs(int widest);
    void fit();
    void askForNew();
    void askForName();

    StationsModel* m_stations = nullptr;
    QWidget* m_place; ///< of the tabs or the list
    QTabBar* m_tabs;
    QComboBox* m_list;
    QToolButton* m_add;
    QToolButton* m_rename;
    QToolButton* m_close;
    QCheckBox* m_forAll;
    SecondPress m_closing; ///< of the station that is shown
};

} // namespace carina
