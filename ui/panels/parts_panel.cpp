#include "ui/panels/parts_panel.h"

#include "widgets/scene/view/scene_view.h"

#include <QGridLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTreeWidget>

#include <algorithm>

namespace carina
{
namespace
{

constexpr int kName = 0;
constexpr int kShown = 1;
constexpr int kButtonsInARow = 3;

std::uint16_t idOf(const QTreeWidgetItem& item)
{
    return static_cast<std::uint16_t>(item.data(kName, Qt::UserRole).toUInt());
}

PartLook lookOf(const PartLooks& looks, std::uint16_t id)
{
    const auto found = looks.find(id);
    return found == looks.end() ? PartLook{} : found->second;
}

} // namespace

PartsPanel::PartsPanel(QWidget* parent)
    : QWidget{parent},
      m_words{new QLineEdit},
      m_parts{new QTreeWidget},
      m_styles{
          styleButton(tr("As &usual"), tr("Show them as their material is usually shown"),
                      PartStyle::AsUsual),
          styleButton(tr("Sol&id"), tr("Show them opaque"), PartStyle::Solid),
          styleButton(tr("Gh&ost"), tr("Show hardly more than their outline"), PartStyle::Ghost),
          styleButton(tr("Hide"), tr("Do not show them"), PartStyle::Hidden)},
      m_highlight{
          switchFor(tr("Highlight"), tr("Show them opaque and yellow"), &PartLook::highlighted)},
      m_label{switchFor(tr("Name"), tr("Write their names beside them"), &PartLook::labelled)},
      m_plain{switchFor(tr("Plain colour"),
                        tr("Colour them by what they are, not as the anatomy set does"),
                        &PartLook::plain)},
      m_showAll{new QPushButton{tr("Show &all as usual")}}
{
    m_words->setObjectName(QStringLiteral("words"));
    m_words->setAccessibleName(tr("Words in the names of parts"));
    m_words->setPlaceholderText(tr("Find parts by words in their names"));
    m_words->setClearButtonEnabled(true);
    m_parts->setObjectName(QStringLiteral("parts"));
    m_parts->setAccessibleName(tr("Parts of the patient"));
    m_parts->setHeaderLabels({tr("Part"), tr("Shown")});
    m_parts->header()->setStretchLastSection(false);
    m_parts->header()->setSectionResizeMode(kName, QHeaderView::Stretch);
    m_parts->header()->setSectionResizeMode(kShown, QHeaderView::ResizeToContents);
    m_parts->setRootIsDecorated(false);
    m_parts->setUniformRowHeights(true);
    m_parts->setSelectionMode(QAbstractItemView::ExtendedSelection);
    m_showAll->setObjectName(QStringLiteral("showAll"));
    connect(m_words, &QLineEdit::textChanged, this, &PartsPanel::filter);
    connect(m_parts, &QTreeWidget::itemSelectionChanged, this, &PartsPanel::refresh);
    connect(m_showAll, &QPushButton::clicked, this, &PartsPanel::showAll);
    layOut();
    refresh();
}

void PartsPanel::layOut()
{
    auto* column = new QVBoxLayout{this};
    column->addWidget(m_words);
    column->addWidget(m_parts, 1);
    auto* buttons = new QGridLayout;
    int place = 0;
    std::vector<QPushButton*> all = m_styles;
    all.insert(all.end(), {m_highlight.button, m_label.button, m_plain.button});
    for (QPushButton* button : all) {
        buttons->addWidget(button, place / kButtonsInARow, place % kButtonsInARow);
        ++place;
    }
    column->addLayout(buttons);
    column->addWidget(m_showAll);
    setFocusProxy(m_words);
}

QPushButton* PartsPanel::styleButton(const QString& text, const QString& toolTip, PartStyle style)
{
    auto* button = new QPushButton{text};
    button->setToolTip(toolTip);
    connect(button, &QPushButton::clicked, this,
            [this, style] { changeChosen([style](PartLook& look) { look.style = style; }); });
    return button;
}

PartsPanel::Switch PartsPanel::switchFor(const QString& text, const QString& toolTip,
                                         bool PartLook::*which)
{
    auto* button = new QPushButton{text};
    button->setToolTip(toolTip);
    button->setCheckable(true);
    connect(button, &QPushButton::clicked, this, [this, which](bool on) {
        changeChosen([which, on](PartLook& look) { look.*which = on; });
    });
    return {button, which};
}

void PartsPanel::setScene(SceneView& scene)
{
    m_scene = &scene;
    m_parts->clear();
    for (const ScenePart& part : scene.parts()) {
        auto* item = new QTreeWidgetItem{m_parts, {QString::fromStdString(part.name)}};
        item->setData(kName, Qt::UserRole, part.id);
    }
    m_plain.button->setVisible(
        std::any_of(scene.parts().begin(), scene.parts().end(),
                    [](const ScenePart& part) { return !part.colors.empty(); }));
    m_parts->sortItems(kName, Qt::AscendingOrder);
    filter(m_words->text());
    refresh();
}

std::vector<std::uint16_t> PartsPanel::chosen() const
{
    std::vector<std::uint16_t> ids;
    for (const QTreeWidgetItem* item : m_parts->selectedItems())
        if (!item->isHidden())
            ids.push_back(idOf(*item));
    return ids;
}

void PartsPanel::changeChosen(const std::function<void(PartLook&)>& change)
{
    PartLooks looks = m_scene->looks();
    for (const std::uint16_t id : chosen())
        change(looks[id]);
    m_scene->setLooks(looks);
    refresh();
}

void PartsPanel::showAll()
{
    m_scene->setLooks({});
    refresh();
}

/// Hides what has not all of the words in its name.
void PartsPanel::filter(const QString& words)
{
    const QStringList wanted = words.split(QLatin1Char{' '}, Qt::SkipEmptyParts);
    for (int row = 0; row < m_parts->topLevelItemCount(); ++row) {
        QTreeWidgetItem* item = m_parts->topLevelItem(row);
        item->setHidden(!std::all_of(wanted.begin(), wanted.end(), [item](const QString& word) {
            return item->text(kName).contains(word, Qt::CaseInsensitive);
        }));
    }
    refresh();
}

void PartsPanel::refresh()
{
    const PartLooks looks = m_scene == nullptr ? PartLooks{} : m_scene->looks();
    for (int row = 0; row < m_parts->topLevelItemCount(); ++row) {
        QTreeWidgetItem* item = m_parts->topLevelItem(row);
        item->setText(kShown, wordsFor(lookOf(looks, idOf(*item))));
    }
    const std::vector<std::uint16_t> ids = chosen();
    for (QPushButton* button : m_styles)
        button->setEnabled(!ids.empty());
    for (const Switch& each : {m_highlight, m_label, m_plain}) {
        each.button->setEnabled(!ids.empty());
        each.button->setChecked(!ids.empty()
                                && std::all_of(ids.begin(), ids.end(), [&](std::uint16_t id) {
                                       return lookOf(looks, id).*each.which;
                                   }));
    }
    m_showAll->setEnabled(m_scene != nullptr);
}

QString PartsPanel::wordsFor(const PartLook& look)
{
    const auto styleWord = [](PartStyle style) {
        switch (style) {
        case PartStyle::AsUsual:
            return tr("as usual");
        case PartStyle::Solid:
            return tr("solid");
        case PartStyle::Ghost:
            return tr("ghost");
        case PartStyle::Hidden:
            return tr("hidden");
        }
        return QString{};
    };
    QString words = look.highlighted ? tr("highlighted") : styleWord(look.style);
    if (look.plain)
        words = tr("%1, plain colour").arg(words);
    return look.labelled ? tr("%1, named").arg(words) : words;
}

} // namespace carina
