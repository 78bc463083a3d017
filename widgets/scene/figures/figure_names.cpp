#include "widgets/scene/figures/figure_names.h"

#include "widgets/scene/labels/leader_lines.h"
#include "widgets/scene/labels/picture_label.h"

#include <QLabel>

#include <algorithm>
#include <utility>

namespace carina
{

void FigureNames::setFigures(std::span<const SceneFigure> figures)
{
    for (const Name& name : m_names)
        delete name.shown;
    m_names.clear();
    m_placed.clear();
    m_figures.assign(figures.begin(), figures.end());
    for (std::size_t i = 0; i < m_figures.size(); ++i)
        for (std::size_t eye = 0; eye < kMostEyes && !m_figures[i].name.isEmpty(); ++eye)
            m_names.push_back({pictureLabel(m_over, m_figures[i].name), i, eye, {}});
    if (m_leaders == nullptr && !m_names.empty())
        m_leaders = new LeaderLines{m_over};
    if (m_leaders != nullptr)
        m_leaders->setLines({});
}

void FigureNames::place(const SceneFrame& frame, std::span<const EyeSight> eyes,
                        std::span<const QRect> taken)
{
    m_placed.clear();
    if (m_names.empty())
        return;
    std::vector<std::size_t> eyeOf; // of each placed name
    for (std::size_t eye = 0; eye < eyes.size(); ++eye) {
        layOut(frame, eyes[eye], eye, taken);
        eyeOf.resize(m_placed.size(), eye);
    }
    write(eyeOf);
}

void FigureNames::layOut(const SceneFrame& frame, const EyeSight& eye, std::size_t number,
                         std::span<const QRect> taken)
{
    std::vector<NameWish> wishes;
    std::vector<Name*> names; // of the wishes
    for (Name& name : m_names) {
        const SceneFigure& figure = m_figures[name.figure];
        const auto body = frame.bodies.find(figure.body);
        if (name.eye != number)
            continue;
        const QRect before = std::exchange(name.before, {});
        if (body == frame.bodies.end())
            continue;
        const auto seen =
            seenPoint(body->second.X_AF * Vec3{body->second.scale * figure.p_F_name}, eye.sight);
        if (!seen)
            continue;
        wishes.push_back({{seen->at.x() * eye.picture.width(), seen->at.y() * eye.picture.height()},
                          seen->depth,
                          name.shown->size(),
                          before});
        names.push_back(&name);
    }
    std::vector<QRect> takenHere;
    for (const QRect& box : taken)
        takenHere.push_back(box.translated(-eye.picture.topLeft()));
    for (PlacedName name : layOutNames(wishes, eye.picture.size(), takenHere)) {
        names[name.wish]->before = name.box;
        name.wish = names[name.wish]->figure;
        name.box.translate(eye.picture.topLeft());
        name.anchor += eye.picture.topLeft();
        name.leaderEnd += eye.picture.topLeft();
        m_placed.push_back(name);
    }
}

void FigureNames::write(const std::vector<std::size_t>& eyes)
{
    std::vector<QLineF> leaders;
    for (const PlacedName& placed : m_placed)
        leaders.emplace_back(placed.anchor, placed.leaderEnd);
    m_leaders->setLines(leaders);
    for (const Name& name : m_names) {
        const PlacedName* placed = nullptr;
        for (std::size_t i = 0; i < m_placed.size(); ++i)
            if (m_placed[i].wish == name.figure && eyes[i] == name.eye)
                placed = &m_placed[i];
        name.shown->setVisible(placed != nullptr);
        if (placed == nullptr)
            continue;
        if (name.shown->pos() != placed->box.topLeft())
            name.shown->move(placed->box.topLeft());
        raiseLabel(*name.shown);
    }
}

std::vector<QRect> FigureNames::boxes() const
{
    std::vector<QRect> boxes;
    for (const PlacedName& placed : m_placed)
        boxes.push_back(placed.box);
    return boxes;
}

} // namespace carina
