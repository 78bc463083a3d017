#pragma once

#include <algorithm>
#include <string>

namespace carina::test
{

/// JSON written with single quotes.
inline std::string json(std::string text)
{
    std::replace(text.begin(), text.end(), '\'', '"');
    return text;
}

/// A site of the smallest kind, and other fields in it.
inline std::string siteWith(const std::string& fields, const std::string& schema = "carina.site/3")
{
    return json("{'schema': '" + schema + "', 'step': 'touch', " + fields + "}");
}

inline std::string siteAt(const std::string& step)
{
    return json("{'schema': 'carina.site/3', 'step': " + step + "}");
}

inline const std::string kCatalogue = "'catalogue': {'name': 'c', 'landmarks': ["
                                      "{'name': 'a', 'p_AQ_mm': [0, 0, 1]},"
                                      "{'name': 'b', 'p_AQ_mm': [0, 1, 0]},"
                                      "{'name': 'c', 'p_AQ_mm': [1, 0, 0]}]}";

/// @param more fields, each with a comma before it
inline std::string touched(const std::string& name, const std::string& more = {})
{
    return "{'landmark': '" + name + "', 'p_TQ_mm': [1, 2, 3], 'spread_mm': 0.5" + more + "}";
}

inline std::string touchedWith(const std::string& more)
{
    return siteWith(kCatalogue + ", 'touched': [" + touched("a", more) + "]");
}

inline std::string registration(const std::string& row, const std::string& rms,
                                const std::string& more = {})
{
    return "'registration': {'X_AM_mm': [[1, 0, 0, 5], " + row
           + ", [0, 0, 1, 7], [0, 0, 0, 1]],"
             "'X_AT_mm': [[1, 0, 0, 5], [0, 1, 0, 6], [0, 0, 1, 7], [0, 0, 0, 1]],"
             "'rms_mm': "
           + rms + ", 'residuals_mm': [{'name': 'a', 'mm': 0.25}]" + more + "}";
}

inline std::string registeredWith(const std::string& more)
{
    return siteWith(registration("[0, 1, 0, 6]", "0.25", ", " + more));
}

inline std::string stylus(const std::string& rms, const std::string& date,
                          const std::string& more = {})
{
    return "{'p_SQ_mm': [0, 0, 1], 'rms_mm': " + rms + ", 'calibrated_at': '" + date + "'" + more
           + "}";
}

inline std::string stylusWith(const std::string& more)
{
    return siteWith("'styluses': [" + stylus("0.3", "2004-03-27", ", " + more) + "]");
}

inline std::string verificationWith(const std::string& verdict, const std::string& more)
{
    return siteWith("'verification': {'verdict': '" + verdict + "'" + more + "}");
}

inline std::string verifiedPoint(const std::string& name)
{
    return "{'name': '" + name
           + "', 'p_AQ_mm': [1, 2, 3], 'p_TQ_mm': [4, 5, 6], 'error_mm': 1, 'bound_mm': 2}";
}

inline std::string display(const std::string& width, const std::string& height)
{
    return "'display': {'p_HDl_mm': [1, 0, 0], 'p_HDr_mm': [1, 0, 0],"
           "'p_HQ_screen_centre_mm': [0, 0, 1], 'screen_width_mm': "
           + width + ", 'screen_height_mm': " + height + "}";
}

} // namespace carina::test
