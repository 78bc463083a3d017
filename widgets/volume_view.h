#pragma once

#include <QColor>
#include <QString>
#include <QWidget>

#include <vector>

namespace carina
{

/// Where things are in the volume that a tracker sees: from the side and from above, with the
/// tracker on the left. What is outside is drawn as a triangle in another colour, at the edge of
/// the picture if it is beyond it.
class VolumeView : public QWidget
{
    Q_OBJECT

public:
    /// Half of the volume's width at a distance from the tracker; any one unit of length.
    struct Section {
        double depth = 0.0;
        double halfHeight = 0.0;
        double halfWidth = 0.0;
    };
    struct Thing {
        QString name{};
        double depth = 0.0;
        double up = 0.0;
        double aside = 0.0;
        bool isInside = true;

        friend bool operator==(const Thing&, const Thing&) = default;
    };

    explicit VolumeView(QWidget* parent = nullptr);

    /// Without sections nothing is drawn.
    void setVolume(std::vector<Section> sections);
    void setThings(std::vector<Thing> things);

    /// Where a thing is drawn in the picture from the side, and from above.
    [[nodiscard]] QPointF placeFromSide(const Thing& thing) const;
    [[nodiscard]] QPointF placeFromAbove(const Thing& thing) const;
    /// Where the names of the things are drawn, in their order: beside the thing, and none upon
    /// another while there is room.
    [[nodiscard]] std::vector<QRectF> namesFromSide() const { return namesIn(0); }
    [[nodiscard]] std::vector<QRectF> namesFromAbove() const { return namesIn(1); }

    [[nodiscard]] QSize sizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    [[nodiscard]] QRectF half(int which) const;
    [[nodiscard]] QPointF placeOf(const Thing& thing, int which) const;
    [[nodiscard]] std::vector<QRectF> namesIn(int which) const;
    [[nodiscard]] QPointF placeIn(const QRectF& picture, double depth, double across) const;
    [[nodiscard]] double unit() const;

    std::vector<Section> m_sections;
    std::vector<Thing> m_things;
};

} // namespace carina
