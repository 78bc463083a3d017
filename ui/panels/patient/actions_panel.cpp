#include "ui/panels/patient/actions_panel.h"

#include "models/text/shown_as_is.h"
#include "ui/refusal_line.h"
#include "ui_actions_panel.h"

#include <QSignalBlocker>

#include <utility>

namespace carina
{
namespace
{

/// Fills a choice anew where it is another; what was chosen stays chosen as far as it is there.
template <class Named> void offer(QComboBox& box, const std::vector<Named>& all)
{
    const auto isShown = [&box](const Named& named, int place) {
        return box.itemData(place).toUInt() == named.id.value && box.itemText(place) == named.name;
    };
    bool isSame = box.count() == int(all.size());
    for (std::size_t place = 0; isSame && place < all.size(); ++place)
        isSame = isShown(all[place], int(place));
    if (isSame)
        return;
    const QSignalBlocker blocker{box};
    const QVariant before = box.currentData();
    box.clear();
    for (const Named& named : all)
        box.addItem(named.name, uint(named.id.value));
    box.setCurrentIndex(std::max(box.findData(before), all.empty() ? -1 : 0));
}

} // namespace

ActionsPanel::ActionsPanel(QWidget* parent)
    : QWidget{parent}, m_ui{std::make_unique<Ui::ActionsPanel>()}
{
    m_ui->setupUi(this);
    auto* refused = new RefusalLine;
    refused->watch(*m_ui->speed);
    m_ui->rows->insertWidget(m_ui->rows->indexOf(m_ui->goRow), refused);
    setFocusProxy(m_ui->object);
}

ActionsPanel::~ActionsPanel() = default;

void ActionsPanel::setModel(ObjectActionModel& model)
{
    m_model = &model;
    connectObject();
    connectAction();
    connect(&model, &ObjectActionModel::changed, this, &ActionsPanel::refresh);
    refresh();
}

void ActionsPanel::connectObject()
{
    SharedObjectModel& object = m_model->object();
    connect(m_ui->object, &QComboBox::activated, this, [this, &object] {
        object.choose(ObjectId{std::uint16_t(m_ui->object->currentData().toUInt())});
    });
    connect(m_ui->lift, &QPushButton::clicked, &object, &SharedObjectModel::lift);
    connect(m_ui->putBack, &QPushButton::clicked, m_model, &ObjectActionModel::putBack);
    connect(m_ui->ask, &QPushButton::clicked, &object, &SharedObjectModel::ask);
    connect(m_ui->takeOver, &QPushButton::clicked, &object, &SharedObjectModel::takeOver);
    connect(m_ui->handOver, &QPushButton::clicked, this, [this, &object] {
        object.handOver(ParticipantId{std::uint16_t(m_ui->heir->currentData().toUInt())});
    });
}

void ActionsPanel::connectAction()
{
    // The entries stand in the order of the enumerators.
    connect(m_ui->kind, &QComboBox::activated, m_model,
            [this](int place) { m_model->setKind(static_cast<ActionKind>(place)); });
    connect(m_ui->axis, &QComboBox::activated, m_model,
            [this](int place) { m_model->setAxis(static_cast<ObjectActionModel::Axis>(place)); });
    connect(m_ui->speed, &QDoubleSpinBox::valueChanged, m_model, &ObjectActionModel::setSpeed);
    connect(m_ui->begin, &QPushButton::clicked, m_model, &ObjectActionModel::start);
    connect(m_ui->stop, &QPushButton::clicked, m_model, &ObjectActionModel::stop);
    connect(m_ui->undoAction, &QPushButton::clicked, m_model, &ObjectActionModel::undo);
    connect(m_ui->reset, &QPushButton::clicked, m_model, &ObjectActionModel::reset);
    connect(m_ui->putAllBack, &QPushButton::clicked, m_model, &ObjectActionModel::putAllBack);
}

void ActionsPanel::refresh()
{
    const QString obstacle = m_model->object().obstacle();
    m_ui->obstacle->setText(obstacle);
    m_ui->obstacle->setVisible(!obstacle.isEmpty());
    m_ui->controls->setVisible(obstacle.isEmpty());
    refreshObject();
    refreshAction();
}

void ActionsPanel::refreshObject()
{
    const SharedObjectModel& object = m_model->object();
    const auto heirs = object.heirs();
    offer(*m_ui->object, object.objects());
    offer(*m_ui->heir, heirs);
    m_ui->owner->setText(object.ownerText());
    m_ui->wish->setText(object.wishText());
    // Whichever is pressed is the last to be shut, so that the keyboard goes on to one of the rest.
    m_ui->putBack->setEnabled(object.canPutBack());
    m_ui->lift->setEnabled(object.canLift());
    m_ui->ask->setText(object.isAsking() ? tr("Do not a&sk any more") : tr("A&sk for it"));
    m_ui->ask->setEnabled(object.canAsk());
    m_ui->takeOver->setVisible(object.isInstructor());
    m_ui->takeOver->setEnabled(object.canTakeOver());
    m_ui->handOver->setEnabled(!heirs.empty());
    m_ui->heir->setEnabled(!heirs.empty());
}

/// A suffix that is set puts the value into the field, in place of what is being typed.
void ActionsPanel::refreshSpeed()
{
    const QSignalBlocker blocker{m_ui->speed};
    if (std::exchange(m_shownKind, m_model->kind()) != m_model->kind()) {
        const auto [largest, unit] = ObjectActionModel::speedScale(m_model->kind());
        m_ui->speed->setRange(-largest, largest);
        m_ui->speed->setSuffix(QLatin1Char(' ') + unit);
        m_ui->speed->setToolTip(shownAsIs(tr("-%1 to %1 %2").arg(largest).arg(unit)));
    }
    if (m_ui->speed->value() != m_model->speed())
        m_ui->speed->setValue(m_model->speed());
}

void ActionsPanel::refreshAction()
{
    m_ui->kind->setCurrentIndex(static_cast<int>(m_model->kind()));
    m_ui->axis->setCurrentIndex(static_cast<int>(m_model->axis()));
    m_ui->axis->setEnabled(m_model->hasAxis());
    refreshSpeed();
    // Whichever is pressed is the last to be shut, so that the keyboard goes on to one of the rest.
    m_ui->putAllBack->setEnabled(m_model->canPutAllBack());
    m_ui->undoAction->setVisible(!m_model->hasHistory()); // which has one for all panels
    if (m_model->hasHistory())
        m_ui->putAllBack->setToolTip(
            tr("Puts back whatever is lifted out, and the patient (Alt+V). One undo takes that "
               "back; but what others held returns to them in its original place, without the "
               "motion that they had given it"));
    m_ui->undoAction->setEnabled(m_model->canUndo());
    m_ui->reset->setEnabled(m_model->canReset());
    m_ui->stop->setEnabled(m_model->canStop());
    m_ui->begin->setEnabled(m_model->canStart());
    m_ui->motion->setText(m_model->motionText());
    m_ui->place->setText(m_model->placeText());
}

} // namespace carina
