#include "ui/panels/patient/parts_panel.h"

#include "models/text/shown_as_is.h"
#include "widgets/scene/view/scene_view.h"

#include <QGridLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalBlocker>
#include <QTreeWidget>

#include <algorithm>
#include <array>
#include <set>

namespace carina
{
namespace
{

constexpr int kName = 0;
constexpr int kShown = 1;
constexpr int kButtonsInARow = 3;
constexpr int kLeastRows = 9; ///< of the list: the regions, and its header

std::uint16_t idOf(const QTreeWidgetItem& item)
{
    return static_cast<std::uint16_t>(item.data(kName, Qt::UserRole).toUInt());
}

/// The parts of a region that the filter leaves in the list.
std::vector<QTreeWidgetItem*> listedParts(const QTreeWidgetItem& region)
{
    std::vector<QTreeWidgetItem*> parts;
    for (int row = 0; row < region.childCount(); ++row)
        if (!region.child(row)->isHidden())
            parts.push_back(region.child(row));
    return parts;
}

/// The parts that an item stands for.
std::vector<std::uint16_t> partsOf(const QTreeWidgetItem& item)
{
    if (item.parent() != nullptr)
        return {idOf(item)};
    std::vector<std::uint16_t> ids;
    for (const QTreeWidgetItem* part : listedParts(item))
        ids.push_back(idOf(*part));
    return ids;
}

bool isShown(const PartLook& look) { return look.style != PartStyle::Hidden || look.highlighted; }

void setShown(PartLook& look, bool shown)
{
    if (shown && look.style == PartStyle::Hidden)
        look.style = PartStyle::AsUsual;
    if (!shown)
        look = {.style = PartStyle::Hidden, .labelled = look.labelled, .plain = look.plain};
}

Qt::CheckState checkFor(std::size_t shown, std::size_t all)
{
    if (shown == 0)
        return Qt::Unchecked;
    return shown == all ? Qt::Checked : Qt::PartiallyChecked;
}

QString regionWord(BodyRegion region)
{
    switch (region) {
    case BodyRegion::Airway:
        return PartsPanel::tr("Airway");
    case BodyRegion::Lungs:
        return PartsPanel::tr("Lungs");
    case BodyRegion::Skeleton:
        return PartsPanel::tr("Skeleton");
    case BodyRegion::Vessels:
        return PartsPanel::tr("Heart and vessels");
    case BodyRegion::Muscles:
        return PartsPanel::tr("Muscles");
    case BodyRegion::Tools:
        return PartsPanel::tr("Tools");
    case BodyRegion::Other:
        return PartsPanel::tr("Other");
    }
    return {};
}

constexpr std::array kRegions{BodyRegion::Airway,  BodyRegion::Lungs,   BodyRegion::Skeleton,
                              BodyRegion::Vessels, BodyRegion::Muscles, BodyRegion::Tools,
                              BodyRegion::Other};

QString styleWord(PartStyle style)
{
    switch (style) {
    case PartStyle::AsUsual:
        return PartsPanel::tr("as usual");
    case PartStyle::Solid:
        return PartsPanel::tr("solid");
    case PartStyle::Ghost:
        return PartsPanel::tr("ghost");
    case PartStyle::Hidden:
        return PartsPanel::tr("hidden");
    }
    return {};
}

QString wordsFor(const PartLook& look)
{
    QString words = look.highlighted ? PartsPanel::tr("highlighted") : styleWord(look.style);
    if (look.plain)
        words = PartsPanel::tr("%1, plain colour").arg(words);
    return look.labelled ? PartsPanel::tr("%1, named").arg(words) : words;
}

PartLook lookOf(const PartLooks& looks, std::uint16_t id)
{
    const auto found = looks.find(id);
    return found == looks.end() ? PartLook{} : found->second;
}

/// A region with its parts by name; nothing where it has none.
void listRegion(QTreeWidget& list, BodyRegion region, const std::vector<ScenePart>& parts)
{
    const Qt::ItemFlags checkable =
        Qt::ItemIsSelectable | Qt::ItemIsEnabled | Qt::ItemIsUserCheckable;
    QList<QTreeWidgetItem*> items;
    for (const ScenePart& part : parts) {
        if (part.listedUnder != region)
            continue;
        auto* item = new QTreeWidgetItem{{QString::fromStdString(part.name)}};
        item->setData(kName, Qt::UserRole, part.id);
        item->setFlags(checkable);
        items.push_back(item);
    }
    if (items.isEmpty())
        return;
    auto* heading = new QTreeWidgetItem{&list, {regionWord(region)}};
    heading->setFlags(checkable);
    heading->addChildren(items);
    heading->sortChildren(kName, Qt::AscendingOrder);
}

} // namespace

PartsPanel::PartsPanel(QWidget* parent)
    : QWidget{parent},
      m_words{new QLineEdit},
      m_parts{new QTreeWidget},
      m_styles{styleButton(tr("As &usual"), tr("Show them as their material is usually shown"),
                           PartStyle::AsUsual),
               styleButton(tr("Sol&id"), tr("Show them opaque"), PartStyle::Solid),
               styleButton(tr("Gh&ost"), tr("Show them almost transparent, with a faint outline"),
                           PartStyle::Ghost),
               styleButton(tr("Hide"), tr("Do not show them"), PartStyle::Hidden)},
      m_highlight{
          switchFor(tr("Highlight"), tr("Show them opaque and yellow"), &PartLook::highlighted)},
      m_label{switchFor(tr("Name"), tr("Write their names beside them"), &PartLook::labelled)},
      m_plain{switchFor(tr("Plain colour"),
                        tr("Colour them by what they are, not as the anatomy set does"),
                        &PartLook::plain)},
      m_showAll{new QPushButton{tr("Show a&ll as usual")}}
{
    m_words->setObjectName(QStringLiteral("words"));
    m_words->setAccessibleName(tr("Filter: words in the names of parts"));
    m_words->setPlaceholderText(tr("Find parts by words in their names"));
    m_words->setClearButtonEnabled(true);
    m_parts->setObjectName(QStringLiteral("parts"));
    m_parts->setAccessibleName(tr("Parts of the patient"));
    m_parts->setHeaderLabels({tr("Part"), tr("Shown")});
    m_parts->header()->setStretchLastSection(false);
    m_parts->header()->setSectionResizeMode(kName, QHeaderView::Stretch);
    m_parts->header()->setSectionResizeMode(kShown, QHeaderView::ResizeToContents);
    m_parts->setUniformRowHeights(true);
    m_parts->setMinimumHeight(kLeastRows * m_parts->fontMetrics().lineSpacing());
    m_parts->setSelectionMode(QAbstractItemView::ExtendedSelection);
    m_showAll->setObjectName(QStringLiteral("showAll"));
    connect(m_words, &QLineEdit::textChanged, this, &PartsPanel::filter);
    connect(m_parts, &QTreeWidget::itemSelectionChanged, this, [this] {
        refresh();
        Q_EMIT chosenInList(chosen());
    });
    connect(m_parts, &QTreeWidget::itemChanged, this, &PartsPanel::showOrHide);
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
    button->setToolTip(shownAsIs(toolTip));
    connect(button, &QPushButton::clicked, this, [this, style] {
        change(chosen(), styleWord(style), [style](PartLook& look) { look.style = style; });
    });
    return button;
}

PartsPanel::Switch PartsPanel::switchFor(const QString& text, const QString& toolTip,
                                         bool PartLook::*which)
{
    auto* button = new QPushButton{text};
    button->setToolTip(shownAsIs(toolTip));
    button->setCheckable(true);
    connect(button, &QPushButton::clicked, this, [this, which, text](bool on) {
        const QString what = QString{text}.remove(QLatin1Char{'&'}).toLower();
        change(chosen(), on ? what : tr("without: %1").arg(what),
               [which, on](PartLook& look) { look.*which = on; });
    });
    return {button, which};
}

void PartsPanel::setScene(SceneView& scene, StationId station, const std::string& patient)
{
    m_kept[m_station].chosen = chosen();
    m_scene = &scene;
    m_station = station;
    Kept& kept = m_kept[station];
    if (patient.empty() || kept.patient != patient) {
        kept = Kept{patient, {}, {}};
        if (m_history)
            m_history->forget(*this, station.value); // those were the parts of another patient
    }
    if (scene.looks() != kept.looks)
        scene.setLooks(kept.looks);
    if (patient.empty() || m_listed != patient)
        list(patient);
    chooseAll(kept.chosen);
    refresh();
}

void PartsPanel::list(const std::string& patient)
{
    m_listed = patient;
    const std::vector<ScenePart>& parts = m_scene->parts();
    const QSignalBlocker silently{m_parts};
    m_parts->clear();
    for (const BodyRegion region : kRegions)
        listRegion(*m_parts, region, parts);
    m_plain.button->setVisible(std::any_of(
        parts.begin(), parts.end(), [](const ScenePart& part) { return !part.colors.empty(); }));
    filter(m_words->text());
}

/// Chooses these and no others, and has their regions open.
void PartsPanel::chooseAll(const std::vector<std::uint16_t>& parts)
{
    const QSignalBlocker silently{m_parts};
    m_parts->clearSelection();
    for (const std::uint16_t part : parts)
        if (QTreeWidgetItem* item = itemOf(part); item != nullptr) {
            item->parent()->setExpanded(true);
            item->setSelected(true);
        }
}

void PartsPanel::choose(std::optional<std::uint16_t> part)
{
    {
        const QSignalBlocker silently{m_parts};
        m_parts->clearSelection();
        QTreeWidgetItem* item = part ? itemOf(*part) : nullptr;
        if (item != nullptr) {
            if (item->isHidden())
                m_words->clear();
            item->setSelected(true);
            m_parts->setCurrentItem(item);
            m_parts->scrollToItem(item);
        }
    }
    refresh();
}

QTreeWidgetItem* PartsPanel::itemOf(std::uint16_t part) const
{
    for (QTreeWidgetItem* region : regions())
        for (int row = 0; row < region->childCount(); ++row)
            if (idOf(*region->child(row)) == part)
                return region->child(row);
    return nullptr;
}

std::vector<QTreeWidgetItem*> PartsPanel::regions() const
{
    std::vector<QTreeWidgetItem*> all;
    for (int row = 0; row < m_parts->topLevelItemCount(); ++row)
        all.push_back(m_parts->topLevelItem(row));
    return all;
}

std::vector<std::uint16_t> PartsPanel::chosen() const
{
    std::set<std::uint16_t> ids;
    for (const QTreeWidgetItem* item : m_parts->selectedItems())
        if (!item->isHidden())
            for (const std::uint16_t id : partsOf(*item))
                ids.insert(id);
    return {ids.begin(), ids.end()};
}

void PartsPanel::change(const std::vector<std::uint16_t>& ids, const QString& what,
                        const std::function<void(PartLook&)>& applied)
{
    PartLooks looks = m_scene->looks();
    for (const std::uint16_t id : ids)
        applied(looks[id]);
    setLooks(looks, tr("%1 → %2", "part of the patient; how it is shown").arg(nameOf(ids), what));
}

void PartsPanel::setLooks(const PartLooks& looks, const QString& text)
{
    if (m_history)
        m_history->add(
            *this, text,
            [this, station = m_station, before = m_scene->looks()] { setLooksAt(station, before); },
            m_station.value, m_station);
    setLooksAt(m_station, looks);
}

/// Also of a station that is not listed: it is shown so once it is again.
void PartsPanel::setLooksAt(StationId station, const PartLooks& looks)
{
    m_kept[station].looks = looks;
    if (station != m_station)
        return;
    m_scene->setLooks(looks);
    refresh();
}

void PartsPanel::put(const PartLooks& looks)
{
    if (looks != m_scene->looks())
        setLooks(looks, tr("Parts → as they were shown"));
}

QString PartsPanel::chosenName() const
{
    const std::vector<std::uint16_t> ids = chosen();
    return ids.size() == 1 ? nameOf(ids) : QString{};
}

/// Of several: how many.
QString PartsPanel::nameOf(const std::vector<std::uint16_t>& ids) const
{
    const QTreeWidgetItem* one = ids.size() == 1 ? itemOf(ids.front()) : nullptr;
    return one ? one->text(kName) : tr("%n parts", nullptr, int(ids.size()));
}

/// After a check box was clicked.
void PartsPanel::showOrHide(QTreeWidgetItem* item, int column)
{
    if (column != kName)
        return;
    const bool shown = item->checkState(kName) != Qt::Unchecked;
    change(partsOf(*item), shown ? tr("shown") : tr("hidden"),
           [shown](PartLook& look) { setShown(look, shown); });
}

void PartsPanel::showAll() { setLooks({}, tr("All parts → as usual")); }

/// Hides what has not all of the words in its name, and opens the regions of what is left.
void PartsPanel::filter(const QString& words)
{
    const QStringList wanted = words.split(QLatin1Char{' '}, Qt::SkipEmptyParts);
    for (QTreeWidgetItem* region : regions()) {
        for (int row = 0; row < region->childCount(); ++row) {
            QTreeWidgetItem* part = region->child(row);
            part->setHidden(!std::all_of(wanted.begin(), wanted.end(), [part](const QString& word) {
                return part->text(kName).contains(word, Qt::CaseInsensitive);
            }));
        }
        region->setHidden(listedParts(*region).empty());
        region->setExpanded(!wanted.isEmpty());
    }
    refresh();
}

void PartsPanel::refresh()
{
    const QSignalBlocker silently{m_parts};
    const PartLooks looks = m_scene == nullptr ? PartLooks{} : m_scene->looks();
    for (QTreeWidgetItem* region : regions())
        refreshRegion(*region, looks);
    refreshButtons(looks);
    m_parts->viewport()->update();
}

void PartsPanel::refreshRegion(QTreeWidgetItem& region, const PartLooks& looks)
{
    std::size_t shown = 0;
    const std::vector<QTreeWidgetItem*> parts = listedParts(region);
    for (QTreeWidgetItem* part : parts) {
        const PartLook look = lookOf(looks, idOf(*part));
        part->setText(kShown, wordsFor(look));
        part->setCheckState(kName, isShown(look) ? Qt::Checked : Qt::Unchecked);
        shown += isShown(look) ? 1 : 0;
    }
    region.setCheckState(kName, checkFor(shown, parts.size()));
    region.setText(kShown, tr("%1 of %2").arg(shown).arg(parts.size()));
    region.setData(
        kName, Qt::AccessibleTextRole,
        tr("%1, %2 of %3 parts shown").arg(region.text(kName)).arg(shown).arg(parts.size()));
}

void PartsPanel::refreshButtons(const PartLooks& looks)
{
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

} // namespace carina
