#include "ui/panels/patient/section_panel.h"

#include "ui/refusal_line.h"
#include "widgets/checked_spin_box.h"
#include "widgets/plain_label.h"
#include "widgets/scene/view/scene_view.h"

#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QSlider>

#include <array>
#include <cmath>
#include <utility>

namespace carina
{
namespace
{

// The choices of what is cut.
constexpr int kNothing = 0;
constexpr int kAroundAirway = 1;
constexpr int kEverything = 2;
constexpr int kAutomatic = 0;
constexpr int kPage_mm = 10;
constexpr double kRounding_mm = 1e-3; ///< of single precision

/// Out of the patient, on the side from which it is cut open.
struct CutSide {
    const char* name;
    Vec3 normal_A;
};
const std::array<CutSide, 6> kSides{{
    {QT_TRANSLATE_NOOP("carina::SectionPanel", "from the front"), -Vec3::UnitY()},
    {QT_TRANSLATE_NOOP("carina::SectionPanel", "from the right side"), -Vec3::UnitX()},
    {QT_TRANSLATE_NOOP("carina::SectionPanel", "from the left side"), Vec3::UnitX()},
    {QT_TRANSLATE_NOOP("carina::SectionPanel", "from the back"), Vec3::UnitY()},
    {QT_TRANSLATE_NOOP("carina::SectionPanel", "from above"), Vec3::UnitZ()},
    {QT_TRANSLATE_NOOP("carina::SectionPanel", "from below"), -Vec3::UnitZ()},
}};

/// Of a change of what is cut at a station, and from where.
int planeTopic(StationId station) { return 2 * station.value; }
int depthTopic(StationId station) { return planeTopic(station) + 1; }

/// The farthest that a box reaches along a direction.
double reach(const Box& box, const Vec3& direction)
{
    return box.empty() ? 0.0
                       : direction.dot(box.centre()) + 0.5 * direction.cwiseAbs().dot(box.size());
}

} // namespace

SectionPanel::SectionPanel(QWidget* parent)
    : QWidget{parent},
      m_what{new QComboBox},
      m_side{new QComboBox},
      m_slider{new QSlider{Qt::Horizontal}},
      m_depth{new CheckedSpinBox},
      m_detail{new QComboBox}
{
    fillChoices();
    layOut();
    connect(m_what, &QComboBox::currentIndexChanged, this, &SectionPanel::choose);
    connect(m_side, &QComboBox::currentIndexChanged, this, &SectionPanel::choose);
    connect(m_slider, &QSlider::valueChanged, m_depth, &QSpinBox::setValue);
    connect(m_depth, &QSpinBox::valueChanged, m_slider, &QSlider::setValue);
    connect(m_depth, &QSpinBox::valueChanged, this, &SectionPanel::cut);
    connect(m_detail, &QComboBox::currentIndexChanged, this, [this](int choice) {
        m_scene->setFixedLevel(choice == kAutomatic ? std::nullopt : std::optional{0});
    });
    setEnabled(false); // until there is a scene
}

void SectionPanel::fillChoices()
{
    m_what->setObjectName(QStringLiteral("what"));
    m_what->setAccessibleName(tr("What is cut"));
    m_what->addItems({tr("Nothing"), tr("Structures around the airway"), tr("Everything")});
    m_side->setObjectName(QStringLiteral("cutFrom"));
    m_side->setAccessibleName(tr("Cut from"));
    for (const CutSide& side : kSides)
        m_side->addItem(tr(side.name));
    m_slider->setObjectName(QStringLiteral("slider"));
    m_slider->setAccessibleName(tr("Depth of the cut"));
    m_slider->setPageStep(kPage_mm);
    m_depth->setObjectName(QStringLiteral("depth"));
    m_depth->setAccessibleName(tr("Depth of the cut in millimetres"));
    m_depth->setSuffix(tr(" mm"));
    m_detail->setObjectName(QStringLiteral("detail"));
    m_detail->setAccessibleName(tr("Detail"));
    m_detail->addItems({tr("Automatic, for a smooth picture"), tr("Full, even if slow")});
}

void SectionPanel::layOut()
{
    auto* depth = new QHBoxLayout;
    depth->addWidget(m_slider, 1);
    depth->addWidget(m_depth);
    auto* form = new QFormLayout{this};
    form->addRow(tr("&Cut"), m_what);
    form->addRow(tr("F&rom"), m_side);
    auto* label = new PlainLabel{tr("Depth")};
    label->setBuddy(m_slider);
    form->addRow(label, depth);
    auto* refused = new RefusalLine;
    refused->watch(*m_depth);
    form->addRow(refused);
    form->addRow(tr("Detail"), m_detail);
}

void SectionPanel::setScene(SceneView& scene, StationId station, const std::string& patient)
{
    m_bounds_A = {};
    for (const ScenePart& part : scene.parts())
        m_bounds_A.include(boundsOf(*part.levels.back()));
    setEnabled(true);
    m_scene = nullptr; // nobody chose what follows
    choose();
    begin(station, patient);
    m_scene = &scene;
    cut();
}

/// With the cut that the station had, if that was of this patient.
void SectionPanel::begin(StationId station, const std::string& patient)
{
    const auto kept = m_kept.find(station);
    const bool isKept = kept != m_kept.end() && !patient.empty() && kept->second.patient == patient;
    if (!isKept && m_history) { // those were cuts of another patient
        m_history->forget(*this, planeTopic(station));
        m_history->forget(*this, depthTopic(station));
    }
    if (isKept) {
        setControls(kept->second.choice);
    } else if (station != m_station) {
        setControls({});
        m_depth->setValue(m_depth->maximum() / 2);
    }
    m_station = station;
    m_choice = choice();
    m_kept.insert_or_assign(station, Kept{patient, m_choice});
}

std::optional<Section> SectionPanel::section() const
{
    if (m_what->currentIndex() == kNothing)
        return std::nullopt;
    const Vec3& normal_A = kSides[static_cast<std::size_t>(m_side->currentIndex())].normal_A;
    const double depth = 1e-3 * m_depth->value();
    return Section{normal_A, reach(m_bounds_A, normal_A) - depth,
                   m_what->currentIndex() == kAroundAirway ? Cut::AllButAirway : Cut::All};
}

/// Another side has another depth; it begins in the middle.
void SectionPanel::choose()
{
    const Vec3& normal_A = kSides[static_cast<std::size_t>(m_side->currentIndex())].normal_A;
    const int deepest = static_cast<int>(std::ceil(
        1e3 * (reach(m_bounds_A, normal_A) + reach(m_bounds_A, -normal_A)) - kRounding_mm));
    const bool isCut = m_what->currentIndex() != kNothing;
    for (QWidget* control : std::initializer_list<QWidget*>{m_side, m_slider, m_depth})
        control->setEnabled(isCut);
    if (m_depth->maximum() != deepest || sender() == m_side) {
        m_slider->setMaximum(deepest);
        m_depth->setMaximum(deepest);
        m_depth->setValue(deepest / 2);
    }
    cut();
}

void SectionPanel::cut()
{
    if (m_scene == nullptr)
        return;
    remember();
    m_scene->setSection(section());
}

SectionPanel::Choice SectionPanel::choice() const
{
    return {m_what->currentIndex(), m_side->currentIndex(), m_depth->value()};
}

/// Depths one after another are one change.
void SectionPanel::remember()
{
    const Choice before = std::exchange(m_choice, choice());
    m_kept[m_station].choice = m_choice;
    if (!m_history || before == m_choice)
        return;
    const bool isDepth = before.what == m_choice.what && before.side == m_choice.side;
    const int topic = isDepth ? depthTopic(m_station) : planeTopic(m_station);
    if (!isDepth || !m_history->goOn(*this, text(), topic))
        m_history->add(
            *this, text(), [this, station = m_station, before] { goBackTo(station, before); },
            topic, m_station);
}

/// Also at a station that is not drawn: it is cut so once it is again.
void SectionPanel::goBackTo(StationId station, const Choice& choice)
{
    m_kept[station].choice = choice;
    if (station != m_station)
        return;
    setControls(choice);
    m_choice = choice;
    cut();
}

/// Without a cut.
void SectionPanel::setControls(const Choice& choice)
{
    SceneView* scene = std::exchange(m_scene, nullptr);
    m_what->setCurrentIndex(choice.what);
    m_side->setCurrentIndex(choice.side);
    m_depth->setValue(choice.depth_mm); // after the side, which has a depth of its own
    m_scene = scene;
}

std::optional<SectionPanel::Choice>
SectionPanel::choiceFor(const std::optional<Section>& section) const
{
    if (!section)
        return Choice{kNothing, m_choice.side, m_choice.depth_mm};
    for (std::size_t side = 0; side < kSides.size(); ++side)
        if (const Vec3& normal_A = kSides[side].normal_A; normal_A.isApprox(section->normal_A))
            return Choice{section->cut == Cut::AllButAirway ? kAroundAirway : kEverything,
                          static_cast<int>(side),
                          qRound(1e3 * (reach(m_bounds_A, normal_A) - section->distance))};
    return std::nullopt;
}

void SectionPanel::put(const std::optional<Section>& section)
{
    const auto choice = choiceFor(section);
    if (!choice)
        return;
    setControls(*choice);
    cut();
}

QString SectionPanel::text() const
{
    if (m_choice.what == kNothing)
        return tr("Cut → nothing");
    return tr("Cut → %1, %2, %3\u00a0mm deep", "what; from which side; how deep")
        .arg(m_what->currentText().toLower(), m_side->currentText())
        .arg(m_choice.depth_mm);
}

} // namespace carina
