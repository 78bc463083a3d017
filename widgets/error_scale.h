#pragma once

#include "widgets/error_bands.h"

#include <QWidget>

#include <optional>
#include <vector>

namespace carina
{

/// The legend of an error map: the colour bands with millimetres at their edges, and the range of
/// the error in words. Empty until setScale().
class ErrorScale : public QWidget
{
    Q_OBJECT

public:
    /// What is drawn, in pixels.
    struct Drawing {
        struct Number {
            double x = 0.0; ///< of the edge above it
            QRectF words;
            QString text;
        };
        QString caption;
        QRectF strip;
        std::vector<QRectF> bands; ///< of the strip, the smallest error first
        std::vector<Number> numbers;
    };

    explicit ErrorScale(QWidget* parent = nullptr);

    /// @param range of the error on the drawn surfaces
    void setScale(const ErrorBands& bands, const ErrorRange& range);

    /// std::nullopt while it is empty.
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
