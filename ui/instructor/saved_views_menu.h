#pragma once

#include "models/console/saved_views.h"

#include <QMenu>

#include <functional>

namespace carina
{

/// The views that the instructor saved: choose one, save the present one, delete one. It is filled
/// each time it opens.
class SavedViewsMenu : public QMenu
{
    Q_OBJECT

public:
    /// Where the camera stands now; its name is not used.
    using Present = std::function<SavedView()>;

    /// @pre views outlives the menu.
    SavedViewsMenu(SavedViews& views, Present present, QWidget* parent = nullptr);

Q_SIGNALS:
    void chosen(const carina::SavedView& view);

private:
    void fill();
    void fillDeletions();
    void askForName();

    SavedViews& m_views;
    Present m_present;
    QMenu* m_deletions;
};

} // namespace carina
