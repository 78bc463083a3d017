#include "ui/panels/airway/head_position_row.h"

#include "models/airway/head_positions.h"
#include "models/text/shown_as_is.h"
#include "widgets/plain_label.h"

#include <QComboBox>
#include <QHBoxLayout>
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
    : QWidget{parent}, m_positions{new QComboBox}, m_present{new PlainLabel}
{
    offerPositions();
    m_present->setObjectName(QStringLiteral("headPositionNow"));
    m_present->setAccessibleName(tr("Present position of head and neck"));
    const QFontMetrics metrics = m_present->fontMetrics();
    m_present->setMinimumSize(
        metrics.horizontalAdvance(neckText({kLeastFlexion, {}})), // the longest
        2 * metrics.lineSpacing());
    auto* label = new PlainLabel{tr("Head")};
    label->setBuddy(m_positions);
    auto* row = new QHBoxLayout{this};
    row->setContentsMargins({});
    row->addWidget(label);
    row->addWidget(m_positions);
    row->addWidget(m_present, 1);
    setFocusProxy(m_positions);
}

void HeadPositionRow::offerPositions()
{
    m_positions->setObjectName(QStringLiteral("headPosition"));
    m_positions->setAccessibleName(tr("Position of head and neck"));
    m_positions->setToolTip(
        tr("How head and neck of the patient lie, over the time of a change; a stiff neck limits "
           "what is drawn. The manikin's head has to be laid so by hand, as nothing measures it"));
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
}

} // namespace carina
