// The channel between threads: order, bounds, and how it ends.
#include "demos/base/platform/channel.h"

#include "tests/catch.h"

#include <atomic>
#include <stdexcept>
#include <thread>
#include <vector>

using namespace pushfactor::demos;

TEST_CASE("a channel gives things in the order in which they were sent, and what is left after it is closed") {
    Channel<int> channel(3);
    for (int i = 0; i < 3; ++i) CHECK(channel.send(i));
    channel.close();
    CHECK_FALSE(channel.send(3));
    for (int i = 0; i < 3; ++i) CHECK(channel.receive() == i);
    CHECK_FALSE(channel.receive());
}

TEST_CASE("a full channel lets its sender wait, until somebody receives or closes it") {
    Channel<int> channel(2);
    std::atomic<int> sent = 0;
    std::thread sender([&] {
        while (channel.send(sent)) ++sent;
    });
    for (int i = 0; i < 100; ++i) {
        CHECK(channel.receive() == i);
        CHECK(sent <= i + 3);
    }
    channel.close();
    sender.join();
    CHECK(sent <= 102);
}

TEST_CASE("a producer works ahead, but not far, and ends when nobody wants more") {
    std::atomic<int> made = 0;
    {
        Producer<int> numbers(2, [&](Channel<int>& channel) {
            while (channel.send(made)) ++made;
        });
        for (int i = 0; i < 5; ++i) CHECK(numbers.next() == i);
    }
    CHECK(made >= 5);
    CHECK(made <= 7);
}

TEST_CASE("what a producer throws comes after all that it made before") {
    Producer<int> numbers(2, [](Channel<int>& channel) {
        for (int i = 0; i < 4; ++i) channel.send(i);
        throw std::runtime_error("out of numbers");
    });
    for (int i = 0; i < 4; ++i) CHECK(numbers.next() == i);
    CHECK_THROWS_WITH(numbers.next(), "out of numbers");
}

TEST_CASE("a producer that has made all gives none any more") {
    Producer<int> numbers(2, [](Channel<int>& channel) { channel.send(7); });
    CHECK(numbers.next() == 7);
    CHECK_FALSE(numbers.next());
    CHECK_FALSE(numbers.next());
}
