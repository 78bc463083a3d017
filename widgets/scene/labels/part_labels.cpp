#include "widgets/scene/labels/part_labels.h"

#include "widgets/scene/labels/leader_lines.h"
#include "widgets/scene/labels/picture_label.h"

#include <QLabel>

#include <algorithm>

namespace carina
{
namespace
{

bool isSame(const CameraPose& a, const CameraPose& b)
{
    return a.p_A_eye == b.p_A_eye && a.p_A_target == b.p_A_target && a.up_A == b.up_A;
}

bool isSame(const Frustum& a, const Frustum& b)
{
    return a.left == b.left && a.right == b.right && a.bottom == b.bottom && a.top == b.top;
}

} // namespace

void PartLabels::clear()
{
    for (const Label& label : m_labels)
        delete label.shown;
    m_labels.clear();
    hide();
    m_sight.reset();
}

void PartLabels::setParts(std::span<const ScenePart> parts, const PartLooks& looks)
{
    clear();
    m_parts.assign(parts.begin(), parts.end());
    for (std::size_t i = 0; i < m_parts.size(); ++i) {
        const ScenePart& part = m_parts[i];
        const auto look = looks.find(part.id);
        if (look != looks.end() && look->second.labelled)
            m_labels.push_back({pictureLabel(m_over, QString::fromStdString(part.name)), i, {}});
    }
    if (m_leaders == nullptr && !m_labels.empty())
        m_leaders = new LeaderLines{m_over};
}

bool PartLabels::isStale(const SceneSight& sight) const
{
    return !m_sight || m_age >= kFramesAPlace || m_sight->section != sight.section
           || !isSame(m_sight->pose, sight.pose) || !isSame(m_sight->frustum, sight.frustum);
}

void PartLabels::findPlaces(const SceneFrame& frame, const SceneSight& sight)
{
    std::vector<std::size_t> wanted;
    for (const Label& label : m_labels)
        wanted.push_back(label.part);
    const auto places = visiblePlaces(m_parts, wanted, frame, sight);
    for (std::size_t i = 0; i < m_labels.size(); ++i)
        m_labels[i].place = places[i];
    m_sight = sight;
    m_age = 0;
}

void PartLabels::place(const SceneFrame& frame, const SceneSight& sight,
                       std::span<const QRect> taken)
{
    if (m_labels.empty())
        return;
    ++m_age;
    if (isStale(sight))
        findPlaces(frame, sight);
    std::vector<NameWish> wishes;
    std::vector<std::size_t> labels; // of the wishes
    for (std::size_t i = 0; i < m_labels.size(); ++i) {
        const Label& label = m_labels[i];
        const ScenePart& part = m_parts[label.part];
        const auto p_A = label.place ? drawnAt(part, *label.place, frame) : std::nullopt;
        const auto seen = p_A ? seenPoint(*p_A, sight) : std::nullopt;
        if (!seen || isCutAway(part, *p_A, sight.section))
            continue;
        wishes.push_back({{seen->at.x() * m_over.width(), seen->at.y() * m_over.height()},
                          seen->depth,
                          label.shown->size()});
        labels.push_back(i);
    }
    m_placed = layOutNames(wishes, m_over.size(), taken);
    for (PlacedName& name : m_placed)
        name.wish = labels[name.wish];
    writeNames();
}

void PartLabels::writeNames()
{
    std::vector<QLineF> leaders;
    std::vector<bool> isWritten(m_labels.size());
    for (const PlacedName& name : m_placed) {
        leaders.emplace_back(name.anchor, name.leaderEnd);
        isWritten[name.wish] = true;
    }
    m_leaders->setLines(leaders);
    for (std::size_t i = 0; i < m_labels.size(); ++i)
        m_labels[i].shown->setVisible(isWritten[i]);
    for (const PlacedName& name : m_placed) {
        QLabel& label = *m_labels[name.wish].shown;
        if (label.pos() != name.box.topLeft())
            label.move(name.box.topLeft());
        raiseLabel(label);
    }
}

void PartLabels::hide()
{
    if (m_leaders != nullptr)
        m_leaders->setLines({});
    m_placed.clear();
    for (const Label& label : m_labels)
        label.shown->hide();
}

} // namespace carina
