#include "ui/panels/airway/head_position_row.h"

#include "models/airway/head_positions.h"
#include "models/text/shown_as_is.h"
#include "widgets/plain_label.h"

#include <QComboBox>
#include <QGridLayout>
#include <QSignalBlocker>

namespace carina
{
namespace
{

constexpr int kPositionLetters = 8;

QString textOfAngles(const HeadPosition& position)
{
    return neckText(position) + QLatin1Char{'\n'} + headText(position);
}

} // namespace

HeadPositionRow::HeadPositionRow(QWidget* parent)
    : QWidget{parent},
      m_positions{new QComboBox},
      m_present{new PlainLabel},
      m_limit{new PlainLabel}
{
    offerPositions();
    m_present->setObjectName(QStringLiteral("headPositionNow"));
    m_present->setAccessibleName(tr("Present position of head and neck"));
    const QFontMetrics metrics = m_present->fontMetrics();
    m_present->setMinimumSize(
        metrics.horizontalAdvance(neckText({kLeastFlexion, {}})), // the longest
        2 * metrics.lineSpacing());
    m_limit->setObjectName(QStringLiteral("headPositionLimit"));
    m_limit->setWordWrap(true);
    auto* label = new PlainLabel{tr("Head")};
    label->setBuddy(m_positions);
    auto* row = new QGridLayout{this};
    row->setContentsMargins({});
    row->setVerticalSpacing(0);
    row->addWidget(label, 0, 0);
    row->addWidget(m_positions, 0, 1);
    row->addWidget(m_present, 0, 2);
    row->addWidget(m_limit, 1, 0, 1, -1);
    row->setColumnStretch(2, 1);
    setFocusProxy(m_positions);
}

void HeadPositionRow::offerPositions()
{
    m_positions->setObjectName(QStringLiteral("headPosition"));
    m_positions->setAccessibleName(tr("Position of head and neck"));
    m_positions->setToolTip(
        tr("How head and neck of the patient lie, over the time of a change; a stiff neck, and the "
           "short one of an infant, limit what is drawn. The manikin's head has to be laid so by "
           "hand, as nothing measures it"));
    m_positions->setPlaceholderText(tr("Other"));
    m_positions->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_positions->setMinimumContentsLength(kPositionLetters);
    for (const UsualHeadPosition& usual : usualHeadPositions()) {
        m_positions->addItem(usualText(usual),
                             QByteArray{usual.name.data(), qsizetype(usual.name.size())});
        m_positions->setItemData(m_positions->count() - 1,
                                 shownAsIs(headPositionText(usual.position)), Qt::ToolTipRole);
    }
}

void HeadPositionRow::setModel(HeadPositionModel& model)
{
    m_model = &model;
    connect(m_positions, &QComboBox::activated, this, &HeadPositionRow::choose);
    connect(&model, &HeadPositionModel::changed, this, &HeadPositionRow::refresh);
    refresh();
}

void HeadPositionRow::choose(int place)
{
    const QByteArray name = m_positions->itemData(place).toByteArray();
    if (const UsualHeadPosition* usual =
            headPositionNamed({name.constData(), static_cast<std::size_t>(name.size())}))
        m_model->setPosition(usual->position);
    refresh();
}

void HeadPositionRow::refresh()
{
    const QSignalBlocker blocker{m_positions};
    const HeadPosition set = m_model->position();
    const UsualHeadPosition* usual = usualOf(set);
    m_positions->setCurrentIndex(usual ? int(usual - usualHeadPositions().data()) : -1);
    m_positions->setAccessibleDescription(headPositionText(set));
    m_present->setText(textOfAngles(m_model->present()));
    const bool isStopped = !m_model->limitText().isEmpty();
    m_limit->setText(isStopped ? tr("This patient's neck flexes no farther.") : QString{});
    m_limit->setVisible(isStopped);
    m_present->setAccessibleDescription(m_limit->text());
}

} // namespace carina
