#pragma once

#include "widgets/error_bands.h"

#include <QWidget>

#include <optional>
#include <vector>

namespace carina
{

/// What the bands of an error map mean: each in its colour, with millimetres where they meet, and
/// in words between which values the error lies. Empty until there is a map.
class ErrorScale : public QWidget
{
    Q_OBJECT

public:
    /// What is drawn, in pixels.
    struct Drawing {
        struct Number {
            double x = 0.0; ///< of the edge that it stands below
            QRectF words;
            QString text;
        };
        QString caption;
        QRectF strip;
        std::vector<QRectF> bands; ///< that make up the strip, the smallest error first
        std::vector<Number> numbers;
    };

    explicit ErrorScale(QWidget* parent = nullptr);

    /// @param range of the error where it is drawn
    void setScale(const ErrorBands& bands, const ErrorRange& range);
    void clear();

    /// Nothing while it is empty.
    [[nodiscard]] std::optional<Drawing> drawing() const;
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    struct Scale {
        ErrorBands bands;
        ErrorRange range;
    };

    std::optional<Scale> m_scale;
};

} // namespace carina
