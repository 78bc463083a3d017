#include "ui/instructor/saved_views_menu.h"

#include "ui/instructor/save_view_dialog.h"

#include <utility>

namespace carina
{
namespace
{

QString withoutMnemonics(QString text)
{
    return text.replace(QLatin1Char{'&'}, QStringLiteral("&&"));
}

} // namespace

SavedViewsMenu::SavedViewsMenu(SavedViews& views, Present present, QWidget* parent)
    : QMenu{parent},
      m_views{views},
      m_present{std::move(present)},
      m_deletions{new QMenu{tr("&Delete a view"), this}}
{
    connect(this, &QMenu::aboutToShow, this, &SavedViewsMenu::fill);
}

void SavedViewsMenu::fill()
{
    clear(); // but for the menu of deletions, which has its own
    for (const SavedView& view : m_views.all())
        addAction(withoutMnemonics(view.name), this, [this, view] { Q_EMIT chosen(view); });
    if (m_views.all().empty())
        addAction(tr("(No view is saved yet)"))->setEnabled(false);
    addSeparator();
    addAction(tr("&Save this view…"), this, &SavedViewsMenu::askForName);
    fillDeletions();
    addMenu(m_deletions);
}

void SavedViewsMenu::fillDeletions()
{
    m_deletions->clear();
    m_deletions->setEnabled(!m_views.all().empty());
    for (const SavedView& view : m_views.all())
        m_deletions->addAction(withoutMnemonics(view.name), &m_views,
                               [this, name = view.name] { m_views.remove(name); });
}

void SavedViewsMenu::askForName()
{
    auto* dialog = new SaveViewDialog{m_views, parentWidget()};
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QDialog::accepted, &m_views, [this, dialog, view = m_present()]() mutable {
        view.name = dialog->name();
        m_views.save(std::move(view));
    });
    dialog->open();
}

} // namespace carina
