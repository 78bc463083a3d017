#include "widgets/vitals/bedside_monitor.h"

#include <QAccessible>
#include <QFontMetrics>
#include <QPainter>
#include <QStyle>
#include <QStyleOptionFocusRect>

#include <algorithm>

namespace carina
{
namespace
{

constexpr double kMonitorMargin = 4.0; ///< pixels
constexpr double kLeastECG_mV = -0.5;
constexpr double kMostECG_mV = 1.5;
constexpr double kPulseRoom = 0.1; ///< of the oximeter's curve, above and below it
constexpr int kLeastLabel = 12;    ///< pixels
constexpr int kMostLabel = 32;
constexpr int kLinesOfLabels = 18;   ///< in the height of the monitor
constexpr int kLabelsAcross = 24;    ///< in its width
constexpr double kNumberShare = 0.3; ///< of the width, beside the curves
constexpr double kNumberLine = 1.15; ///< height of a line of figures, of its font
constexpr double kLowerLine = 1.7;   ///< of the words' font: of the line beneath, at most
constexpr double kFinger = 1.6;      ///< width of the marks' place, of the words' font

constexpr std::array kAllRows{BedsideMonitor::Row::Electrocardiogram, BedsideMonitor::Row::Pulse,
                              BedsideMonitor::Row::Capnogram};

QString orDash(std::optional<int> number)
{
    return number ? QString::number(*number) : QStringLiteral("–");
}

/// As many marks as the alarm is urgent.
QString marksOf(BedsideMonitor::Urgency urgency) { return QString(int(urgency) + 1, QChar{u'▲'}); }

} // namespace

BedsideMonitor::BedsideMonitor(QWidget* parent)
    : QWidget{parent},
      m_curves{SweepCurve{kFastSweep_s, kLeastECG_mV, kMostECG_mV},
               SweepCurve{kFastSweep_s, -kPulseRoom, 1.0 + kPulseRoom},
               SweepCurve{kSlowSweep_s, 0.0, kUsualCO2_mmHg}}
{
    setFocusPolicy(Qt::TabFocus);
    setMinimumSize(kLeast);
    tellChange();
}

/// Those that bedside monitors mostly have.
QColor BedsideMonitor::colourOf(Row row)
{
    switch (row) {
    case Row::Electrocardiogram:
        return {110, 220, 120};
    case Row::Pulse:
        return {100, 200, 240};
    case Row::Capnogram:
        break;
    }
    return {240, 215, 110};
}

/// Red, yellow and cyan, as IEC 60601-1-8 has them.
QColor BedsideMonitor::colourOf(Urgency urgency)
{
    switch (urgency) {
    case Urgency::High:
        return {200, 30, 40};
    case Urgency::Medium:
        return {245, 215, 60};
    case Urgency::Low:
        break;
    }
    return {90, 215, 230};
}

void BedsideMonitor::add(const Sample& sample)
{
    m_curves[std::size_t(Row::Electrocardiogram)].add(sample.time_s, sample.electrocardiogram_mV);
    m_curves[std::size_t(Row::Pulse)].add(sample.time_s, sample.pulse);
    SweepCurve& capnogram = m_curves[std::size_t(Row::Capnogram)];
    if (sample.exhaledCO2_mmHg.value_or(0.0) > capnogram.top())
        capnogram.setTop(kMostCO2_mmHg);
    capnogram.add(sample.time_s, sample.exhaledCO2_mmHg);
    update();
}

void BedsideMonitor::clear()
{
    for (SweepCurve& curve : m_curves)
        curve.clear();
    m_curves[std::size_t(Row::Capnogram)].setTop(kUsualCO2_mmHg);
    update();
}

void BedsideMonitor::setNumbers(const Numbers& numbers)
{
    m_numbers = numbers;
    tellChange();
}

void BedsideMonitor::setAlarms(std::vector<Alarm> alarms)
{
    const bool isNew =
        !alarms.empty() && (m_alarms.empty() || m_alarms.front().text != alarms.front().text);
    m_alarms = std::move(alarms);
    tellChange();
    if (!isNew)
        return;
    QAccessibleEvent event{this, QAccessible::Alert};
    QAccessible::updateAccessibility(&event);
}

void BedsideMonitor::setSoundNote(const QString& note)
{
    m_soundNote = note;
    tellChange();
}

void BedsideMonitor::setPulse(bool isOn)
{
    m_pulse = isOn;
    update();
}

void BedsideMonitor::tellChange()
{
    const QString told = words();
    if (told != accessibleName())
        setAccessibleName(told);
    update();
}

QString BedsideMonitor::words() const
{
    QStringList told{tr("Bedside monitor")};
    for (const Alarm& alarm : m_alarms)
        told << tr("alarm of %1: %2").arg(alarm.priority, alarm.text);
    if (!m_soundNote.isEmpty())
        told << m_soundNote;
    const auto tell = [&told](const QString& text, std::optional<int> number) {
        if (number)
            told << text.arg(*number);
    };
    tell(tr("heart rate %1 per minute"), m_numbers.heartRate_perMin);
    tell(tr("SpO2 %1 per cent"), m_numbers.saturation_percent);
    tell(tr("end-tidal CO2 %1 mmHg"), m_numbers.endTidalCO2_mmHg);
    tell(tr("respiratory rate %1 per minute"), m_numbers.respiratoryRate_perMin);
    if (const auto& pressure = m_numbers.pressure)
        told << tr("blood pressure %1 over %2, mean %3 mmHg")
                    .arg(pressure->systolic_mmHg)
                    .arg(pressure->diastolic_mmHg)
                    .arg(pressure->mean_mmHg);
    return told.join(QStringLiteral("; "));
}

QString BedsideMonitor::labelOf(Row row)
{
    switch (row) {
    case Row::Electrocardiogram:
        return tr("HR bpm", "heart rate, beats per minute; as short as that");
    case Row::Pulse:
        return tr("SpO2 %");
    case Row::Capnogram:
        break;
    }
    return tr("EtCO2 mmHg");
}

std::optional<int> BedsideMonitor::numberOf(Row row) const
{
    switch (row) {
    case Row::Electrocardiogram:
        return m_numbers.heartRate_perMin;
    case Row::Pulse:
        return m_numbers.saturation_percent;
    case Row::Capnogram:
        break;
    }
    return m_numbers.endTidalCO2_mmHg;
}

QString BedsideMonitor::rateText() const
{
    return tr("RR %1\u00a0/min", "respiratory rate; as short as that")
        .arg(orDash(m_numbers.respiratoryRate_perMin));
}

QString BedsideMonitor::pressureText() const
{
    if (!m_numbers.pressure)
        return tr("BP –\u00a0mmHg", "blood pressure; as short as that");
    return tr("%1/%2 (%3)\u00a0mmHg", "blood pressure: systolic, diastolic, mean")
        .arg(m_numbers.pressure->systolic_mmHg)
        .arg(m_numbers.pressure->diastolic_mmHg)
        .arg(m_numbers.pressure->mean_mmHg);
}

QFont BedsideMonitor::sized(int pixels) const
{
    QFont font = this->font();
    font.setPixelSize(pixels);
    return font;
}

/// The size of a font, up to `most`, with which a text is not wider than that.
int BedsideMonitor::fitting(const QString& widest, double width, int most) const
{
    constexpr int kMeasured = 100; // pixels, of which each text is a share
    const int wide = QFontMetrics{sized(kMeasured)}.horizontalAdvance(widest);
    return std::clamp(int(kMeasured * width / wide), 1, most);
}

BedsideMonitor::Drawing BedsideMonitor::drawing() const
{
    Drawing drawn;
    const QRectF all =
        QRectF{rect()}.adjusted(kMonitorMargin, kMonitorMargin, -kMonitorMargin, -kMonitorMargin);
    drawn.labelPixels = std::clamp(std::min(height() / kLinesOfLabels, width() / kLabelsAcross),
                                   kLeastLabel, kMostLabel);
    const double line = QFontMetrics{sized(drawn.labelPixels)}.height();
    drawn.alarm = {all.left(), all.top(), all.width(), line + kMonitorMargin};
    const double note = QFontMetrics{sized(drawn.labelPixels)}.horizontalAdvance(m_soundNote);
    drawn.soundNote = drawn.alarm;
    drawn.soundNote.setLeft(
        std::max(all.left(), all.right() - (note > 0.0 ? note + 2.0 * kMonitorMargin : 0.0)));
    const QString lower = tr("RR %1\u00a0/min", "respiratory rate; as short as that").arg(188)
                          + tr("%1/%2 (%3)\u00a0mmHg", "blood pressure: systolic, diastolic, mean")
                                .arg(188)
                                .arg(188)
                                .arg(188);
    drawn.lowerPixels =
        fitting(lower, all.width() - 4.0 * kMonitorMargin, int(kLowerLine * drawn.labelPixels));
    const double lowerLine = QFontMetrics{sized(drawn.lowerPixels)}.height();
    const double rateWidth =
        QFontMetrics{sized(drawn.lowerPixels)}.horizontalAdvance(rateText()) + kMonitorMargin;
    drawn.respiratoryRate = {all.left(), all.bottom() - lowerLine, rateWidth, lowerLine};
    drawn.pressure = {all.left() + rateWidth, all.bottom() - lowerLine, all.width() - rateWidth,
                      lowerLine};
    placeStrips({all.left(), drawn.alarm.bottom() + kMonitorMargin, all.width(),
                 drawn.pressure.top() - drawn.alarm.bottom() - 2.0 * kMonitorMargin},
                drawn);
    return drawn;
}

void BedsideMonitor::placeStrips(const QRectF& room, Drawing& drawn) const
{
    const double high = room.height() / kRows;
    const double label = QFontMetrics{sized(drawn.labelPixels)}.height();
    const double words =
        QFontMetrics{sized(drawn.labelPixels)}.horizontalAdvance(labelOf(Row::Capnogram));
    const double wide = std::max(kNumberShare * room.width(), words + kFinger * drawn.labelPixels);
    const int most = int((high - label) / kNumberLine);
    drawn.numberPixels = fitting(QStringLiteral("188"), wide - kMonitorMargin, most);
    for (const Row row : kAllRows) {
        Drawing::Strip& strip = drawn.strips[std::size_t(row)];
        const double top = room.top() + double(row) * high;
        strip.frame = {room.left(), top, room.width() - wide - kMonitorMargin,
                       high - kMonitorMargin};
        strip.label = {room.right() - wide, top, wide, label};
        strip.number = {room.right() - wide, top + label, wide, high - label};
        strip.lines = m_curves[std::size_t(row)].lines(strip.frame);
        strip.bar = m_curves[std::size_t(row)].bar(strip.frame);
    }
    drawn.pulseMark = drawn.strips[std::size_t(Row::Pulse)].label;
    drawn.pulseMark.setLeft(drawn.pulseMark.right() - kFinger * drawn.labelPixels);
}

void BedsideMonitor::drawAlarm(QPainter& painter, const Drawing& drawn) const
{
    painter.setFont(sized(drawn.labelPixels));
    QRectF room = drawn.alarm;
    room.setRight(drawn.soundNote.left());
    painter.setPen(palette().color(QPalette::Text));
    QString text = m_numbers == Numbers{} ? tr("○ Nothing is measured") : tr("✓ No alarm");
    if (!m_alarms.empty()) {
        const Alarm& first = m_alarms.front();
        painter.fillRect(room, colourOf(first.urgency));
        painter.setPen(first.urgency == Urgency::High ? Qt::white : Qt::black);
        text = QStringLiteral("%1 %2, %3").arg(marksOf(first.urgency), first.text, first.priority);
        if (m_alarms.size() > 1)
            text = tr("%1 (+%2)", "an alarm; how many others there are")
                       .arg(text)
                       .arg(m_alarms.size() - 1);
    }
    room.adjust(kMonitorMargin, 0.0, -kMonitorMargin, 0.0);
    painter.drawText(room, Qt::AlignLeft | Qt::AlignVCenter,
                     painter.fontMetrics().elidedText(text, Qt::ElideRight, int(room.width())));
    painter.setPen(palette().color(QPalette::Text));
    painter.drawText(drawn.soundNote, Qt::AlignRight | Qt::AlignVCenter, m_soundNote);
}

void BedsideMonitor::drawStrip(QPainter& painter, Row row, const Drawing& drawn) const
{
    const Drawing::Strip& strip = drawn.strips[std::size_t(row)];
    painter.setPen(palette().color(QPalette::Mid));
    painter.drawLine(strip.frame.bottomLeft(), strip.frame.bottomRight());
    painter.setFont(sized(drawn.labelPixels));
    painter.setPen(palette().color(QPalette::PlaceholderText));
    if (row == Row::Capnogram)
        painter.drawText(strip.frame, Qt::AlignLeft | Qt::AlignTop,
                         QString::number(m_curves[std::size_t(row)].top()));
    painter.setPen(colourOf(row));
    painter.drawText(strip.label, Qt::AlignLeft | Qt::AlignVCenter, labelOf(row));
    if (row == Row::Pulse && m_pulse)
        painter.drawText(drawn.pulseMark, Qt::AlignRight | Qt::AlignVCenter, QStringLiteral("♥"));
    painter.setFont(sized(drawn.numberPixels));
    painter.drawText(strip.number, Qt::AlignLeft | Qt::AlignVCenter, orDash(numberOf(row)));
    painter.setPen({colourOf(row), 2.0});
    for (const QPolygonF& line : strip.lines)
        painter.drawPolyline(line);
    if (!strip.bar)
        return;
    painter.setPen(palette().color(QPalette::Text));
    painter.drawLine(QPointF{*strip.bar, strip.frame.top()},
                     QPointF{*strip.bar, strip.frame.bottom()});
}

void BedsideMonitor::drawLower(QPainter& painter, const Drawing& drawn) const
{
    painter.setFont(sized(drawn.lowerPixels));
    painter.setPen(colourOf(Row::Capnogram));
    painter.drawText(drawn.respiratoryRate, Qt::AlignLeft | Qt::AlignVCenter, rateText());
    painter.setPen(palette().color(QPalette::Text));
    painter.drawText(drawn.pressure, Qt::AlignRight | Qt::AlignVCenter, pressureText());
}

void BedsideMonitor::paintEvent(QPaintEvent*)
{
    QPainter painter{this};
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(rect(), palette().color(QPalette::Base));
    const Drawing drawn = drawing();
    drawAlarm(painter, drawn);
    for (const Row row : kAllRows)
        drawStrip(painter, row, drawn);
    drawLower(painter, drawn);
    if (hasFocus()) {
        QStyleOptionFocusRect focus;
        focus.initFrom(this);
        style()->drawPrimitive(QStyle::PE_FrameFocusRect, &focus, &painter, this);
    }
}

} // namespace carina
