#pragma once

#include "widgets/vitals/sweep_curve.h"

#include <QWidget>

#include <array>
#include <optional>
#include <vector>

namespace carina
{

/// A bedside monitor: electrocardiogram, plethysmogram and capnogram, written by a moving bar, with
/// their numbers beside them in large figures, respiratory rate and blood pressure beneath, and the
/// alarms above in words: the most urgent one in a line of its own, its priority and the others in
/// the next. It is readable from kLeast to the whole screen: figures and words grow with it.
class BedsideMonitor : public QWidget
{
    Q_OBJECT

public:
    /// From above down.
    enum class Row : std::uint8_t { Electrocardiogram, Pulse, Capnogram };
    static constexpr std::size_t kRows = 3;

    struct Sample {
        double time_s = 0.0;
        double electrocardiogram_mV = 0.0;
        std::optional<double> pulse{}; ///< 0 to 1
        std::optional<double> exhaledCO2_mmHg{};
    };
    struct BloodPressure {
        int systolic_mmHg = 0;
        int diastolic_mmHg = 0;
        int mean_mmHg = 0;

        friend bool operator==(const BloodPressure&, const BloodPressure&) = default;
    };
    /// What is not measured is empty, and drawn as a dash.
    struct Numbers {
        std::optional<int> heartRate_perMin{};
        std::optional<int> saturation_percent{};
        std::optional<int> endTidalCO2_mmHg{};
        std::optional<int> respiratoryRate_perMin{};
        std::optional<BloodPressure> pressure{};

        friend bool operator==(const Numbers&, const Numbers&) = default;
    };
    enum class Urgency : std::uint8_t { Low, Medium, High };
    struct Alarm {
        Urgency urgency = Urgency::Low;
        QString text{};     ///< "SpO2 below 85 %"
        QString priority{}; ///< "high priority"
    };
    /// Where things are drawn, in pixels.
    struct Drawing {
        struct Strip {
            QRectF frame; ///< of the curve
            QRectF label; ///< two lines: what is measured, and its unit
            QRectF number;
            std::vector<QPolygonF> lines;
            std::optional<double> bar; ///< x of the write bar
        };
        QRectF alarm;     ///< two lines, also without an alarm: nothing beneath moves
        QRectF soundNote; ///< at the right end of the second one
        std::array<Strip, kRows> strips;
        QRectF pulseMark; ///< beside the oximeter's unit
        QRectF respiratoryRate;
        QRectF pressure;
        int labelPixels = 0;  ///< height of the words' font
        int numberPixels = 0; ///< of the large figures
        int lowerPixels = 0;  ///< of the line beneath
    };

    static constexpr QSize kLeast{300, 200};
    static constexpr double kFastSweep_s = 6.0;    ///< of the heart's curves: 25 mm/s on 150 mm
    static constexpr double kSlowSweep_s = 12.0;   ///< of the capnogram
    static constexpr double kUsualCO2_mmHg = 60.0; ///< the top of its scale
    static constexpr double kMostCO2_mmHg = 120.0; ///< while there is more than usual

    explicit BedsideMonitor(QWidget* parent = nullptr);

    void add(const Sample& sample);
    /// Removes the curves.
    void clear();
    void setNumbers(const Numbers& numbers);
    /// The most urgent first. A screen reader hears when another one comes first.
    void setAlarms(std::vector<Alarm> alarms);
    /// Shown beneath the alarm, at the right: that something is mute. Empty: nothing is.
    void setSoundNote(const QString& note);
    /// A mark that stands for the oximeter's tone.
    void setPulse(bool isOn);

    [[nodiscard]] static QColor colourOf(Row row);
    [[nodiscard]] static QColor colourOf(Urgency urgency);
    [[nodiscard]] Drawing drawing() const;
    /// All that is read off it, as the accessible name has it.
    [[nodiscard]] QString words() const;

    /// As low as it may be: what is beside it gets the room that it needs first.
    [[nodiscard]] QSize sizeHint() const override { return {420, kLeast.height()}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return kLeast; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    [[nodiscard]] static QString nameOf(Row row);
    [[nodiscard]] static QString unitOf(Row row);
    [[nodiscard]] std::optional<int> numberOf(Row row) const;
    [[nodiscard]] QString rateText() const;
    [[nodiscard]] QString pressureText() const;
    [[nodiscard]] QFont sized(int pixels) const;
    [[nodiscard]] int fitting(const QString& widest, double width, int most) const;
    [[nodiscard]] double wordsWidth(int pixels) const;
    [[nodiscard]] QString othersText() const;
    void placeAlarm(const QRectF& room, Drawing& drawn) const;
    void placeLower(const QRectF& room, Drawing& drawn) const;
    void placeStrips(const QRectF& room, Drawing& drawn) const;
    void drawAlarm(QPainter& painter, const Drawing& drawn) const;
    void write(Row row, double time_s, std::optional<double> value);
    void drawNumber(QPainter& painter, Row row, const Drawing& drawn) const;
    /// What of it lies within that.
    void drawCurve(QPainter& painter, Row row, const Drawing& drawn, const QRectF& wanted) const;
    void drawLower(QPainter& painter, const Drawing& drawn) const;
    void tellChange();

    std::array<SweepCurve, kRows> m_curves;
    std::array<QRectF, kRows> m_frames; ///< as they were painted
    Numbers m_numbers;
    std::vector<Alarm> m_alarms;
    QString m_soundNote;
    bool m_pulse = false;
};

} // namespace carina
