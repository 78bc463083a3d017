#include "widgets/vitals/bedside_monitor.h"

#include <QAccessible>
#include <QFontMetrics>
#include <QPaintEvent>
#include <QPainter>
#include <QStyle>
#include <QStyleOptionFocusRect>

#include <algorithm>

namespace carina
{
namespace
{

constexpr double kMonitorMargin = 4.0; ///< pixels
constexpr double kPen = 2.0;           ///< width of a curve, pixels
constexpr double kLeastECG_mV = -0.5;
constexpr double kMostECG_mV = 1.5;
constexpr double kPulseRoom = 0.1; ///< of the oximeter's curve, above and below it
constexpr int kLeastLabel = 14;    ///< pixels
constexpr int kMostLabel = 32;
constexpr int kLinesOfLabels = 15;    ///< in the height of the monitor
constexpr int kLabelsAcross = 26;     ///< in its width
constexpr double kNumberShare = 0.28; ///< of the width, at most
constexpr double kNumberLine = 1.15;  ///< height of a line of figures, of its font
constexpr double kPulseMark = 1.5;    ///< width of the pulse's mark, of the words' font
constexpr double kLowerLine = 1.7;    ///< of the words' font: of the line beneath, at most

constexpr std::array kAllRows{BedsideMonitor::Row::Electrocardiogram, BedsideMonitor::Row::Pulse,
                              BedsideMonitor::Row::Capnogram};

QString orDash(std::optional<int> number)
{
    return number ? QString::number(*number) : QStringLiteral("–");
}

/// Of a line from left to right what passes between two places, with a neighbour at either end.
QPolygonF between(const QPolygonF& line, double from, double to)
{
    const auto isBefore = [](const QPointF& p, double x) { return p.x() < x; };
    auto first = std::lower_bound(line.begin(), line.end(), from, isBefore);
    auto last = std::lower_bound(first, line.end(), to, isBefore);
    first -= first == line.begin() ? 0 : 1;
    last += last == line.end() ? 0 : 1;
    return QPolygonF{QList<QPointF>{first, last}};
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
    write(Row::Electrocardiogram, sample.time_s, sample.electrocardiogram_mV);
    write(Row::Pulse, sample.time_s, sample.pulse);
    SweepCurve& capnogram = m_curves[std::size_t(Row::Capnogram)];
    if (sample.exhaledCO2_mmHg.value_or(0.0) > capnogram.top()) {
        capnogram.setTop(kMostCO2_mmHg);
        update();
    }
    write(Row::Capnogram, sample.time_s, sample.exhaledCO2_mmHg);
}

/// What is written does not move, so only what the bar passes is painted anew.
void BedsideMonitor::write(Row row, double time_s, std::optional<double> value)
{
    SweepCurve& curve = m_curves[std::size_t(row)];
    const QRectF& frame = m_frames[std::size_t(row)];
    const auto before = curve.bar(frame);
    curve.add(time_s, value);
    const auto bar = curve.bar(frame);
    QRectF passed = frame;
    if (before && bar && *before <= *bar) {
        passed.setLeft(*before);
        passed.setRight(*bar + SweepCurve::kGapShare * frame.width());
    }
    update(passed.adjusted(-kPen, -kPen, kPen, kPen).toAlignedRect());
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

QString BedsideMonitor::nameOf(Row row)
{
    switch (row) {
    case Row::Electrocardiogram:
        return tr("HR", "heart rate; as short as that");
    case Row::Pulse:
        return tr("SpO2");
    case Row::Capnogram:
        break;
    }
    return tr("EtCO2");
}

QString BedsideMonitor::unitOf(Row row)
{
    switch (row) {
    case Row::Electrocardiogram:
        return tr("/min");
    case Row::Pulse:
        return tr("%");
    case Row::Capnogram:
        break;
    }
    return tr("mmHg");
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
    return tr("BP %1/%2 (%3)\u00a0mmHg", "blood pressure: systolic, diastolic, mean")
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

/// Of the widest name or unit.
double BedsideMonitor::wordsWidth(int pixels) const
{
    const QFontMetrics metrics{sized(pixels)};
    int widest = 0;
    for (const Row row : kAllRows)
        widest = std::max({widest, metrics.horizontalAdvance(nameOf(row)),
                           metrics.horizontalAdvance(unitOf(row))});
    return widest;
}

BedsideMonitor::Drawing BedsideMonitor::drawing() const
{
    Drawing drawn;
    const QRectF all =
        QRectF{rect()}.adjusted(kMonitorMargin, kMonitorMargin, -kMonitorMargin, -kMonitorMargin);
    drawn.labelPixels = std::clamp(std::min(height() / kLinesOfLabels, width() / kLabelsAcross),
                                   kLeastLabel, kMostLabel);
    placeAlarm(all, drawn);
    placeLower(all, drawn);
    placeStrips({all.left(), drawn.alarm.bottom() + kMonitorMargin, all.width(),
                 drawn.pressure.top() - drawn.alarm.bottom() - kMonitorMargin},
                drawn);
    return drawn;
}

void BedsideMonitor::placeAlarm(const QRectF& room, Drawing& drawn) const
{
    const QFontMetrics metrics{sized(drawn.labelPixels)};
    const double line = metrics.height();
    drawn.alarm = {room.left(), room.top(), room.width(), 2.0 * line};
    const double wide =
        m_soundNote.isEmpty() ? 0.0 : metrics.horizontalAdvance(m_soundNote) + kMonitorMargin;
    drawn.soundNote = drawn.alarm.adjusted(std::max(0.0, room.width() - wide), line, 0.0, 0.0);
}

void BedsideMonitor::placeLower(const QRectF& room, Drawing& drawn) const
{
    const QString widest =
        tr("RR %1\u00a0/min", "respiratory rate; as short as that").arg(188)
        + tr("BP %1/%2 (%3)\u00a0mmHg", "blood pressure: systolic, diastolic, mean")
              .arg(188)
              .arg(188)
              .arg(188);
    drawn.lowerPixels =
        fitting(widest, room.width() - 4.0 * kMonitorMargin, int(kLowerLine * drawn.labelPixels));
    const QFontMetrics metrics{sized(drawn.lowerPixels)};
    const double rate = metrics.horizontalAdvance(rateText()) + kMonitorMargin;
    const double top = room.bottom() - metrics.height();
    drawn.respiratoryRate = {room.left(), top, rate, room.bottom() - top};
    drawn.pressure = {room.left() + rate, top, room.width() - rate, room.bottom() - top};
}

/// Words at the left of a number rather than above it: both have the height of the curve.
void BedsideMonitor::placeStrips(const QRectF& room, Drawing& drawn) const
{
    const QString widest = QStringLiteral("188");
    const double high = room.height() / kRows;
    drawn.numberPixels = fitting(widest, kNumberShare * room.width(), int(high / kNumberLine));
    const double number =
        QFontMetrics{sized(drawn.numberPixels)}.horizontalAdvance(widest) + kMonitorMargin;
    const double words = wordsWidth(drawn.labelPixels) + kMonitorMargin;
    const double curve = room.width() - number - words - kMonitorMargin;
    for (const Row row : kAllRows) {
        Drawing::Strip& strip = drawn.strips[std::size_t(row)];
        const double top = room.top() + double(row) * high;
        strip.frame = {room.left(), top, curve, high - kMonitorMargin};
        strip.label = {strip.frame.right() + kMonitorMargin, top, words, high};
        strip.number = {strip.label.right(), top, number, high};
        strip.lines = m_curves[std::size_t(row)].lines(strip.frame);
        strip.bar = m_curves[std::size_t(row)].bar(strip.frame);
    }
    drawn.pulseMark = drawn.strips[std::size_t(Row::Pulse)].label;
    drawn.pulseMark.setTop(drawn.pulseMark.center().y());
    drawn.pulseMark.setLeft(drawn.pulseMark.right() - kPulseMark * drawn.labelPixels);
}

/// How urgent the first alarm is, and which others there are.
QString BedsideMonitor::othersText() const
{
    QStringList others;
    for (std::size_t i = 1; i < m_alarms.size(); ++i)
        others << m_alarms[i].text;
    const QString priority = m_alarms.front().priority;
    return others.isEmpty() ? priority
                            : tr("%1; also: %2", "priority of the first alarm; the other alarms")
                                  .arg(priority, others.join(QStringLiteral(", ")));
}

void BedsideMonitor::drawAlarm(QPainter& painter, const Drawing& drawn) const
{
    painter.setFont(sized(drawn.labelPixels));
    QRectF first = drawn.alarm;
    first.setBottom(drawn.soundNote.top());
    QRectF second = drawn.alarm;
    second.setTop(first.bottom());
    second.setRight(drawn.soundNote.left());
    painter.setPen(palette().color(QPalette::Text));
    painter.drawText(drawn.soundNote, Qt::AlignRight | Qt::AlignVCenter, m_soundNote);
    const auto write = [&painter](QRectF place, const QString& text) {
        place.adjust(kMonitorMargin, 0.0, -kMonitorMargin, 0.0);
        painter.drawText(
            place, Qt::AlignLeft | Qt::AlignVCenter,
            painter.fontMetrics().elidedText(text, Qt::ElideRight, int(place.width())));
    };
    if (m_alarms.empty())
        return write(first,
                     m_numbers == Numbers{} ? tr("○ Nothing is measured") : tr("✓ No alarm"));
    const Alarm& alarm = m_alarms.front();
    painter.fillRect(first, colourOf(alarm.urgency));
    painter.fillRect(second, colourOf(alarm.urgency));
    painter.setPen(alarm.urgency == Urgency::High ? Qt::white : Qt::black);
    write(first, QStringLiteral("%1 %2").arg(marksOf(alarm.urgency), alarm.text));
    write(second, othersText());
}

void BedsideMonitor::drawNumber(QPainter& painter, Row row, const Drawing& drawn) const
{
    const Drawing::Strip& strip = drawn.strips[std::size_t(row)];
    painter.setFont(sized(drawn.labelPixels));
    QRectF name = strip.label;
    name.setBottom(name.center().y());
    QRectF unit = strip.label;
    unit.setTop(name.bottom());
    painter.setPen(colourOf(row));
    painter.drawText(name, Qt::AlignLeft | Qt::AlignBottom, nameOf(row));
    painter.drawText(unit, Qt::AlignLeft | Qt::AlignTop, unitOf(row));
    if (row == Row::Pulse && m_pulse)
        painter.drawText(drawn.pulseMark, Qt::AlignRight | Qt::AlignTop, QStringLiteral("♥"));
    painter.setFont(sized(drawn.numberPixels));
    painter.drawText(strip.number, Qt::AlignRight | Qt::AlignVCenter, orDash(numberOf(row)));
}

/// With the top of the capnogram's scale, which others do not have.
void BedsideMonitor::drawCurve(QPainter& painter, Row row, const Drawing& drawn,
                               const QRectF& wanted) const
{
    const Drawing::Strip& strip = drawn.strips[std::size_t(row)];
    painter.setPen(palette().color(QPalette::Mid));
    painter.drawLine(strip.frame.bottomLeft(), strip.frame.bottomRight());
    painter.setFont(sized(drawn.labelPixels));
    painter.setPen(palette().color(QPalette::PlaceholderText));
    if (row == Row::Capnogram)
        painter.drawText(
            strip.frame, Qt::AlignLeft | Qt::AlignTop,
            tr("%1\u00a0mmHg", "top of a scale").arg(m_curves[std::size_t(row)].top()));
    painter.setPen({colourOf(row), kPen});
    for (const QPolygonF& line : strip.lines)
        painter.drawPolyline(between(line, wanted.left() - kPen, wanted.right() + kPen));
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

void BedsideMonitor::paintEvent(QPaintEvent* event)
{
    QPainter painter{this};
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(rect(), palette().color(QPalette::Base));
    const Drawing drawn = drawing();
    const QRegion& wanted = event->region();
    const auto isWanted = [&wanted](const QRectF& place) {
        return wanted.intersects(place.toAlignedRect());
    };
    if (isWanted(drawn.alarm))
        drawAlarm(painter, drawn);
    for (const Row row : kAllRows) {
        const Drawing::Strip& strip = drawn.strips[std::size_t(row)];
        m_frames[std::size_t(row)] = strip.frame;
        const QRectF around = strip.frame.adjusted(-kPen, -kPen, kPen, kPen);
        if (isWanted(around))
            drawCurve(painter, row, drawn, (wanted & around.toAlignedRect()).boundingRect());
        if (isWanted(strip.label | strip.number))
            drawNumber(painter, row, drawn);
    }
    if (isWanted(drawn.respiratoryRate | drawn.pressure))
        drawLower(painter, drawn);
    if (hasFocus()) {
        QStyleOptionFocusRect focus;
        focus.initFrom(this);
        style()->drawPrimitive(QStyle::PE_FrameFocusRect, &focus, &painter, this);
    }
}

} // namespace carina
